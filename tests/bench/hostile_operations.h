/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* The operations whose cost may depend on where the points lie. */
#ifndef JALON_BENCH_HOSTILE_OPERATIONS_H
#define JALON_BENCH_HOSTILE_OPERATIONS_H

#include "hostile_clouds.h"
#include "hostile_fields.h"
#include "hostile_pairs.h"

/* What the tests' table does not have. */
static const struct {
  const char* name;
  operation run;
} kMore[] = {
    {"normals triangulation", op_triangulation},
    {"normals radius", op_normals_radius},
    {"normals quadric radius", op_quadric_radius},
    {"chi-square radius", op_chi_square_radius},
    {"features radius", op_features_radius},
    {"outliers radius", op_outliers_radius},
    {"octree sample", op_octree_sample},
    {"crop cylinder", op_crop_cylinder},
    {"crop polygon", op_crop_polygon},
    {"moments", op_moments},
    {"knn", op_knn},
    {"knn at level", op_knn_at_level},
    {"knn all", op_knn_all},
    {"cells", op_cells},
    {"gradient", op_gradient},
    {"gradient fitted", op_slopes},
    {"filter mean", op_mean},
    {"filter median", op_median},
    {"filter median of k", op_median_k},
    {"classes", op_classes},
    {"histogram", op_histogram},
    {"noise law", op_noise_law},
    {"map distance", op_chamfer},
    {"map distance marching", op_marching},
    {"distance map", op_distance_map},
    {"fit sphere", op_fit_sphere},
    {"fit circle", op_fit_circle},
    {"sphere targets", op_sphere_targets},
    {"flat targets", op_flat_targets},
    {"nearest", op_nearest},
    {"nearest within", op_within},
    {"distance delaunay", op_delaunay},
    {"distance quadric", op_quadrics},
    {"preview", op_preview},
    {"preview angles", op_preview_angles},
    {"m3c2 core", op_m3c2_core},
    {"hidden vertical", op_hidden_vertical},
    {"hidden occluders", op_hidden_occluders},
    {"depth map", op_depth_map},
    {"regions of changes", op_regions_lifted},
    {"diagnosis of changes", op_diagnose_lifted},
    {"outlines of changes", op_outlines_lifted},
    {"deviation picture", op_deviations},
    {"coarse registration", op_coarse},
    {"evaluate segments", op_evaluate},
    {"outlines", op_outlines},
    {"extrusion", op_extrusion},
    {"picture", op_picture},
    {"distance from mesh", op_from_mesh},
    {"clearance", op_clearance},
    {"sample mesh", op_sample_mesh},
    {"sweep", op_sweep},
};
enum { kMoreCount = sizeof kMore / sizeof *kMore, kAllCount = kOperationCount + kMoreCount };
static inline const char* name_of(int which) {
  return which < kOperationCount ? kOperations[which].name : kMore[which - kOperationCount].name;
}
static inline operation operation_of(int which) {
  return which < kOperationCount ? kOperations[which].run : kMore[which - kOperationCount].run;
}

/* The answer of a radius search is as long as there are neighbours, that of a depth map as there are cells: their time
 * is told for each row as well, and they are stopped later. */
static inline uint64_t answered_by(operation run, const made* out) {
  const char* field = run == op_radius ? "index" : run == op_depth_map ? "range" : NULL;
  jalon_array_view rows;
  if (field == NULL || out->fields == NULL) return 1;
  MUST(jalon_fields_view(out->fields, field, &rows));
  return rows.count > 0 ? rows.count : 1;
}

/* The index, and what some operations keep of a cloud, are made before they are measured. */
static inline void make_ready(const jalon_cloud* cloud, int operation_number) {
  const struct both_ways* both;
  const operation run = operation_of(operation_number);
  MUST(jalon_cloud_prepare(cloud, NULL));
  if (run == op_regions || run == op_diagnose || run == op_change_outlines)
    (void)!compare_both_ways(cloud, &both);
  if (run == op_regions_lifted || run == op_diagnose_lifted || run == op_outlines_lifted ||
      run == op_deviations)
    (void)!compare_lifted(cloud, &both);
}

static inline int named(int argc, char** argv, int argument, const char* name) {
  return argc <= argument || strcmp(argv[argument], "all") == 0 ||
         strcmp(argv[argument], name) == 0;
}

#endif
