/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
#include "wall_scene.h"

/* The whole file as text, freed by the caller; NULL when there is none. */
static char* text_of_file(const char* path) {
  FILE* file = fopen(path, "rb");
  if (file == NULL) return NULL;
  fseek(file, 0, SEEK_END);
  const long size = ftell(file);
  rewind(file);
  char* text = malloc((size_t)size + 1);
  assert_non_null(text);
  assert_int_equal(fread(text, 1, (size_t)size, file), size);
  text[size] = 0;
  fclose(file);
  return text;
}

static char folder[] = "/tmp/jalon_report_XXXXXX";

static const char* in_folder(const char* name) {
  static char path[256];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

static int make_folder(void** state) {
  (void)state;
  return mkdtemp(folder) == NULL;
}

static int remove_folder(void** state) {
  (void)state;
  const char* names[] = {"a.svg", "a.html", "a.json", "b.svg", "b.html", "b.json",
                         "b.PNG", "o.png",  "o.pgw",  "o.tif", "o.html"};
  for (size_t i = 0; i < sizeof names / sizeof *names; ++i) remove(in_folder(names[i]));
  return rmdir(folder);
}

static void report__writes_drawing_page_and_json(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model* model = model_of_scene(&scene);
  const char* notes =
      "{\"title\": \"<b>Wall</b>\", \"input\": {\"file\": \"a&b.las\"}, \"times\": {\"read\": "
      "0.5}}";
  MUST(jalon_report_write_elevation(scene.segmentation, model, in_folder("a.svg"), NULL, NULL));
  MUST(jalon_report_write_html(scene.segmentation, model, notes, in_folder("a.html"), NULL, NULL));
  MUST(jalon_report_write_json(scene.segmentation, model, notes, in_folder("a.json"), NULL, NULL));
  char* svg = text_of_file(in_folder("a.svg"));
  char* html = text_of_file(in_folder("a.html"));
  char* json = text_of_file(in_folder("a.json"));
  assert_non_null(strstr(svg, "<svg"));
  assert_non_null(strstr(svg, "Height Z (m)"));
  assert_non_null(strstr(html, "&lt;b&gt;Wall"));
  assert_null(strstr(html, "<b>Wall"));
  assert_non_null(strstr(html, "a&amp;b.las"));
  assert_non_null(strstr(json, "\"planes\""));
  free(svg);
  free(html);
  free(json);
  jalon_model_release(model);
  release_scene(&scene);
}

static void report__options_set_title_and_scale(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model* model = model_of_scene(&scene);
  jalon_params* options = NULL;
  MUST(jalon_params_create("elevation", &options));
  MUST(jalon_params_set_string(options, "title", "North side"));
  MUST(jalon_params_set_int64(options, "scale", 200));
  MUST(jalon_report_write_elevation(scene.segmentation, model, in_folder("a.svg"), options, NULL));
  char* svg = text_of_file(in_folder("a.svg"));
  assert_non_null(strstr(svg, "North side"));
  assert_non_null(strstr(svg, "1:200"));
  free(svg);
  REFUSED(
      JALON_ERROR_INVALID_ARGUMENT,
      jalon_report_write_html(scene.segmentation, model, NULL, in_folder("a.html"), options, NULL));
  jalon_params_release(options);
  jalon_model_release(model);
  release_scene(&scene);
}

static void report__failures_leave_the_old_file_alone(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model* model = model_of_scene(&scene);
  FILE* old = fopen(in_folder("a.html"), "wb");
  assert_non_null(old);
  fputs("old", old);
  fclose(old);
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_report_write_html(scene.segmentation, model, "{not json", in_folder("a.html"), NULL,
                                  NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT, jalon_report_write_html(scene.segmentation, model, "\xff",
                                                                in_folder("a.html"), NULL, NULL));
  char* text = text_of_file(in_folder("a.html"));
  assert_string_equal(text, "old");
  free(text);
  REFUSED(JALON_ERROR_IO, jalon_report_write_elevation(scene.segmentation, model,
                                                       in_folder("none/a.svg"), NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_report_write_elevation(NULL, model, in_folder("a.svg"), NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_report_write_elevation(scene.segmentation, NULL, in_folder("a.svg"), NULL, NULL));
  REFUSED(JALON_ERROR_INVALID_ARGUMENT,
          jalon_report_write_json(scene.segmentation, model, NULL, NULL, NULL, NULL));
  jalon_model_release(model);
  release_scene(&scene);
}

static void report__writes_an_orthoimage_of_the_wall_with_its_world_file(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model* model = model_of_scene(&scene);
  jalon_params* options = NULL;
  MUST(jalon_params_create("orthoimage", &options));
  MUST(jalon_params_set_double(options, "pixel_m", 0.125));
  MUST(jalon_report_write_orthoimage(scene.segmentation, model, in_folder("o.png"), options, NULL));
  MUST(jalon_report_write_orthoimage(scene.segmentation, model, in_folder("o.tif"), NULL, NULL));
  char *png = text_of_file(in_folder("o.png")), *world = text_of_file(in_folder("o.pgw"));
  char *tiff = text_of_file(in_folder("o.tif")), *page = NULL;
  assert_true(memcmp(png, "\x89PNG\r\n\x1a\n", 8) == 0);
  assert_true(memcmp(tiff, "II*\0", 4) == 0);
  assert_true(strncmp(world, "0.125\n0\n0\n-0.125\n", 17) == 0);
  MUST(jalon_report_write_html(scene.segmentation, model, NULL, in_folder("o.html"), NULL, NULL));
  page = text_of_file(in_folder("o.html"));
  assert_non_null(strstr(page, ">Orthoimage<"));
  REFUSED(JALON_ERROR_UNSUPPORTED,
          jalon_report_write_orthoimage(scene.segmentation, model, in_folder("o.jpg"), NULL, NULL));
  MUST(jalon_params_set_int64(options, "facade", 9));
  REFUSED(
      JALON_ERROR_INVALID_ARGUMENT,
      jalon_report_write_orthoimage(scene.segmentation, model, in_folder("p.png"), options, NULL));
  assert_null(fopen(in_folder("p.png"), "rb"));
  free(png), free(world), free(tiff), free(page);
  jalon_params_release(options);
  jalon_model_release(model);
  release_scene(&scene);
}

static void report__needs_no_model_and_draws_the_labelled_points(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  MUST(jalon_report_write_html(scene.segmentation, NULL, NULL, in_folder("b.html"), NULL, NULL));
  MUST(jalon_report_write_json(scene.segmentation, NULL, NULL, in_folder("b.json"), NULL, NULL));
  MUST(jalon_report_write_picture(scene.segmentation, in_folder("b.svg"), NULL, NULL));
  MUST(jalon_report_write_picture(scene.segmentation, in_folder("b.PNG"), NULL, NULL));
  char *page = text_of_file(in_folder("b.html")), *drawing = text_of_file(in_folder("b.svg"));
  char* png = text_of_file(in_folder("b.PNG"));
  assert_non_null(strstr(page, "Labelled points"));
  assert_null(strstr(page, "Elevation"));
  assert_non_null(strstr(page, "data:image/png;base64,"));
  assert_non_null(strstr(drawing, "data:image/png;base64,"));
  assert_non_null(strstr(drawing, "Distance along the facade (m)"));
  assert_true(memcmp(png, "\x89PNG\r\n\x1a\n", 8) == 0);
  free(page), free(drawing), free(png);
  jalon_params* options = NULL;
  MUST(jalon_params_create("picture", &options));
  MUST(jalon_params_set_string(options, "view", "plan"));
  MUST(jalon_params_set_string(options, "title", "<A & B>"));
  MUST(jalon_report_write_picture(scene.segmentation, in_folder("b.svg"), options, NULL));
  drawing = text_of_file(in_folder("b.svg"));
  assert_non_null(strstr(drawing, "&lt;A &amp; B&gt;: plan view, 1 segments of"));
  free(drawing);
  jalon_params_release(options);
  release_scene(&scene);
}

static jalon_model* facade_of_scene(const wall_scene* scene) {
  jalon_modeller* modeller = NULL;
  jalon_model* model = NULL;
  MUST(jalon_modeller_create("facade", &modeller));
  MUST(jalon_modeller_run(modeller, scene->cloud, scene->segmentation, NULL, &model));
  jalon_modeller_release(modeller);
  return model;
}

static void report__draws_a_facade_model_with_dimensions_and_the_given_source(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model* model = facade_of_scene(&scene);
  jalon_params* options = NULL;
  MUST(jalon_params_create("elevation", &options));
  MUST(jalon_params_set_string(options, "source", "<wall>.las"));
  MUST(jalon_params_set_string(options, "date", "2026-11-21"));
  MUST(jalon_report_write_elevation(scene.segmentation, model, in_folder("a.svg"), options, NULL));
  char* svg = text_of_file(in_folder("a.svg"));
  for (size_t i = 0; i < 5; ++i) {
    const char* texts[] = {"&lt;wall&gt;.las", "2026-11-21",
                           ("\xC2\xB1"
                            "0.00"),
                           "Distance along the facade (m)", "class=\"face\""};
    if (strstr(svg, texts[i]) == NULL) fail_msg("no %s in the drawing", texts[i]);
  }
  free(svg);
  MUST(jalon_params_set_int64(options, "facade", 1));
  MUST(jalon_report_write_elevation(scene.segmentation, model, in_folder("b.svg"), options, NULL));
  MUST(jalon_params_set_int64(options, "facade", 2));
  REFUSED(
      JALON_ERROR_INVALID_ARGUMENT,
      jalon_report_write_elevation(scene.segmentation, model, in_folder("c.svg"), options, NULL));
  assert_null(text_of_file(in_folder("c.svg")));
  jalon_params_release(options);
  jalon_model_release(model);
  release_scene(&scene);
}

static void report__tells_parts_openings_and_precision(void** state) {
  (void)state;
  wall_scene scene = make_wall_scene();
  jalon_model* model = facade_of_scene(&scene);
  const jalon_transform pose = {{1, 0, 0, 3, 0, 1, 0, -20, 0, 0, 1, 2}};
  const char* notes = "{\"scanner\": {\"sigma_range_m\": 0.003}}";
  REFUSED(JALON_ERROR_NOT_FOUND,
          jalon_report_write_json(scene.segmentation, model, "{\"scanner\": {\"nose\": 1}}",
                                  in_folder("c.json"), NULL, NULL));
  MUST(jalon_report_write_html(scene.segmentation, model, NULL, in_folder("a.html"), NULL, NULL));
  MUST(jalon_report_write_json(scene.segmentation, model, NULL, in_folder("a.json"), NULL, NULL));
  char *page = text_of_file(in_folder("a.html")), *json = text_of_file(in_folder("a.json"));
  assert_non_null(strstr(page, ">Parts<"));
  assert_non_null(strstr(page, ">Precision<"));
  for (size_t i = 0; i < 4; ++i) {
    const char* names[] = {"\"openings\"", "\"opening_types\"", "\"parts\"",
                           "\"sigma_normal_rad\""};
    if (strstr(json, names[i]) == NULL) fail_msg("no %s in the JSON", names[i]);
  }
  assert_null(strstr(json, "variance_factor"));
  free(page), free(json);
  jalon_model_release(model);
  /* The same points with a known station. */
  jalon_segmenter* segmenter = NULL;
  jalon_segmentation* stationed = NULL;
  MUST(jalon_cloud_set_station(scene.cloud, "S", &pose));
  MUST(jalon_segmenter_create("ransac", &segmenter));
  MUST(jalon_segmenter_run(segmenter, scene.cloud, NULL, &stationed));
  MUST(jalon_report_write_json(stationed, NULL, notes, in_folder("b.json"), NULL, NULL));
  json = text_of_file(in_folder("b.json"));
  assert_non_null(strstr(json, "variance_factor"));
  free(json);
  jalon_segmentation_release(stationed);
  jalon_segmenter_release(segmenter);
  release_scene(&scene);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(report__needs_no_model_and_draws_the_labelled_points),
      cmocka_unit_test(report__draws_a_facade_model_with_dimensions_and_the_given_source),
      cmocka_unit_test(report__tells_parts_openings_and_precision),
      cmocka_unit_test(report__writes_drawing_page_and_json),
      cmocka_unit_test(report__writes_an_orthoimage_of_the_wall_with_its_world_file),
      cmocka_unit_test(report__options_set_title_and_scale),
      cmocka_unit_test(report__failures_leave_the_old_file_alone),
  };
  return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
