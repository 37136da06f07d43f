/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* A stranger's program: C99, the installed headers and library, nothing else. Prints the release and what it found. */
#include <jalon/jalon.h>
#include <stdio.h>

static double square[4][3] = {
    {652000, 6861000, 0}, {652001, 6861000, 0}, {652001, 6861001, 0}, {652000, 6861001, 0.5}};

static int report(const char* what) {
  fprintf(stderr, "%s: %s\n", what, jalon_last_error_message());
  return 1;
}

int main(void) {
  jalon_cloud* cloud = NULL;
  jalon_box box;
  uint64_t nearest[2];
  if (jalon_version_number() != JALON_VERSION_NUMBER) return report("another release");
  if (jalon_cloud_create(square, JALON_FLOAT64, 4, 0, 0, &cloud) != JALON_OK)
    return report("create");
  if (jalon_cloud_bounds(cloud, &box) != JALON_OK) return report("bounds");
  if (jalon_cloud_knn(cloud, square[3], JALON_FLOAT64, 1, 0, 2, JALON_LEVEL_AUTOMATIC, NULL,
                      nearest, NULL) != JALON_OK)
    return report("knn");
  jalon_cloud_release(cloud);
  if (box.max.z != 0.5 || nearest[0] != 3) return 1;
  printf("jalon %s\n", jalon_version());
  return 0;
}
