/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file scanner.h
 * The virtual scanner: a model and stations in, a cloud with ground truth out; and ready-made
 * scenes.
 */
#ifndef JALON_SCANNER_H
#define JALON_SCANNER_H

#include <jalon/cloud.h>
#include <jalon/model.h>
#include <jalon/trajectory.h>

JALON_BEGIN_C

typedef struct jalon_scanner jalon_scanner;

/**
 * method: "static" (NULL = the same): a tripod scanner turning about its vertical axis, with
 * shadows, noise, station misfit, beam width, mixed pixels and glass; "sample": random points on
 * all faces, seen or not, with noise along their normals; "mobile": a vehicle along a trajectory with
 * a plane scanner or a rotating head, run by jalon_scanner_drive.
 */
JALON_API JALON_CHECK jalon_status jalon_scanner_create(const char* method, jalon_scanner** out);
/** The names of the methods, the default first. Static texts. */
JALON_API JALON_CHECK jalon_status jalon_scanner_methods(const char* const** names,
                                                         uint64_t* count);
/** A scanner of its own of the same method, with the same values, with its stations. */
JALON_API JALON_CHECK jalon_status jalon_scanner_copy(const jalon_scanner* scanner,
                                                      jalon_scanner** out);
JALON_API jalon_scanner* jalon_scanner_retain(jalon_scanner* scanner);
JALON_API void jalon_scanner_release(jalon_scanner* scanner);
/**
 * The scanner's own parameter set. "static": angular steps, field of view, noise (or an
 * instrument's), misfit, beam, glass, dropout, outliers, thinning, automatic stations, seed,
 * offset. "sample": number or spacing of the points, noise, glass, ...
 */
JALON_API JALON_CHECK jalon_status jalon_scanner_params(jalon_scanner* scanner, jalon_params** out);
/**
 * Adds a station; pose maps scanner to world coordinates and must be a rigid motion: where the
 * scanner truly stands. name may be NULL. A scanner of method "sample" with a station refuses to
 * run.
 */
JALON_API JALON_CHECK jalon_status jalon_scanner_add_station(jalon_scanner* scanner,
                                                             const char* name,
                                                             const jalon_transform* pose);
/**
 * Scans the model. "static" without a station places tripods 1.7 m above the model's lowest point:
 * two in front of a facade at 0.6 x its width, two on the long axis of a street or room, four
 * around a building, by the way its upright faces look.
 *
 * Fields of the cloud; the last two of "static" alone:
 *     column           type         unit  meaning
 *     face             uint32       -     the id of the face hit; UINT32_MAX for an outlier
 *     segment          uint32       -     the number of the true plane, see jalon_scanner_truth; 0
 *                                         for points of none: outliers, mixed pixels, curved
 *                                         surfaces, small faces
 *     true_xyz         float64 x 3  m     the point without noise, on the model
 *     range            float32      m     from the scanner, without noise
 *     incidence_angle  float32      rad   between the ray and the face's normal; if the parameter
 *                                         says so
 *
 * "static" gives one station of the cloud for each of the scanner's, with the pose recorded: the
 * true one but for the misfit, by which the points are off as well. A mixed pixel is a return whose
 * sub-rays met several true planes within the range resolution; its "face" is the one that gives
 * most of it. Glass (faces of parts of class "glass", and panes of windows) returns a share of the
 * pulses and lets the others pass. Same seed, same bits, whatever the threads.
 */
JALON_API JALON_CHECK jalon_status jalon_scanner_run(const jalon_scanner* scanner,
                                                     const jalon_model* model, jalon_task* task,
                                                     jalon_cloud** out);

/**
 * Drives along the trajectory and scans the model with a scanner of method "mobile": every pulse from where the
 * vehicle is at its time to the nearest triangle within range. Points are made of the measured range and angles,
 * noise included, as jalon_trajectory_georeference makes them, whose parameters the scanner has for its mount. The
 * trajectory is the true one: perturb it (jalon_trajectory_perturb) and georeference again to have its errors. Same
 * seed, same bits, whatever the threads. JALON_ERROR_UNSUPPORTED for other methods.
 *
 * Fields beside those of jalon_trajectory_georeference; block, facade and strip are those of a model of
 * jalon_model_building_strips, exact matches of the points:
 *     column    type         unit  meaning
 *     range     float64      m     as measured
 *     theta     float64      rad   as measured
 *     phi       float64      rad   as measured
 *     face      uint32       -     the id of the face hit
 *     block     uint32       -     number of the block hit; UINT32_MAX: the face has none above it
 *     facade    uint32       -     number of the facade hit, or UINT32_MAX
 *     strip     uint32       -     number of the strip hit, or UINT32_MAX
 *     true_xyz  float64 x 3  m     where the beam ended, on the model
 */
JALON_API JALON_CHECK jalon_status jalon_scanner_drive(const jalon_scanner* scanner,
                                                       const jalon_model* model,
                                                       const jalon_trajectory* trajectory,
                                                       jalon_task* task, jalon_cloud** out);

/**
 * The true planes of the model: connected groups of coplanar faces (within 0.001 degrees and 0.1
 * mm, sharing an edge or touching) from the area truth_min_area_m2 on. Faces without a plane
 * (cylinders, spheres, leaves) belong to none; in a model made by jalon_model_create_mesh every
 * triangle counts. O(n log n) for n triangles.
 *
 * - cloud: NULL, or one with the field "segment", as jalon_scanner_run gives it.
 *
 * One row a plane:
 *     column   type         unit  meaning
 *     segment  uint32       -     1, 2 ... in the order of the model's triangles; the number in the
 *                                 points' field "segment"
 *     face     uint32       -     id of its largest face
 *     part     uint32       -     part of that face
 *     normal   float64 x 3  1     out of that face
 *     offset   float64      m     normal . p = offset, offset_m included
 *     area     float64      m2    openings taken off
 *     count    uint64       -     points of the cloud with that number; 0 without a cloud
 */
JALON_API JALON_CHECK jalon_status jalon_scanner_truth(const jalon_scanner* scanner,
                                                       const jalon_model* model,
                                                       const jalon_cloud* cloud, jalon_task* task,
                                                       jalon_fields** out);

/**
 * A ready-made scene. Operation "scene": name, turn, shift and sizes; see the parameter table.
 *
 * - facade (22 x 10 m, doors, windows with reveals, cornice, ground), street (60 m, six facades,
 *   boxes, columns: that of the measurements with other programs), room, box.
 * - After Boulaassal (2010), chapter 3: insa (68 x 22 m of posts, bands, breast walls, mullions,
 *   glass and curtains, cars and a stair in front), surrounds, unwanted (the same behind trees,
 *   cars, pedestrians, with furniture behind the glass), std (ten planes), normal (one), strips
 *   (six, staggered), patches (two of one plane), sills, robbery (a shelf along a wall).
 * - Chapters 4 and 5: insa_surveyed, residence (the same with balconies), lycee (six facades, eight
 *   arched windows, two trees before them), arches (two walls with square and arched windows).
 * - After Girardeau-Montaut (2006), 2.3.3: earthworks (60 x 40 m of rolling ground with two walls
 *   of 8 m and a free one of 6 x 0.3 x 3 m, on four days: a heap of 3 x 1 m on day 2; on day 3 a
 *   pit of 8 x 5 x 1.2 m, 40.6 m3, and an excavator; on day 4 that has moved 6 m and turned by 40
 *   degrees, and the free wall is gone). Ids on all days: ground 1, heap 2, pit 3, back and side
 *   wall 4 and 5, free wall 6 to 10, excavator from 11 on.
 * - grammar: a facade made by rules, another one for each seed, of the kind asked for (town_house,
 *   apartments, shops, arcade, offices, gabled, wings, loggias, church, factory, terrace, mansard;
 *   by name only: timbered, villa, school, sheds, nave, warehouse, staggered, corner), with what
 *   stands in its windows, rooms behind the glass, and trees, cars and people in front. It brings
 *   its own scanner (jalon_scene_scanner) and tells its walls and openings
 *   (jalon_scene_write_truth).
 * - yard: four low buildings of corrugated sheet about a yard, after the survey of a master's thesis on feature codes
 *   (University of Liege 2021): doors, windows with panes, blinds and sills, two of them half open, gutters, eaves,
 *   bushes, coded targets; for scanner "sample", with "glass_return_min" and "densities". It brings the code lists
 *   of targets and of a total-station survey (jalon_scene_write_truth).
 *
 * options may be NULL for the defaults. The model carries the true planes as faces with their
 * openings in a tree of parts with classes (wall, post, band, mullion, glass, curtain, sill,
 * joinery, tree, car, ghost ...), and the triangles that are scanned.
 */
JALON_API JALON_CHECK jalon_status jalon_scene_create(const jalon_params* options, jalon_task* task,
                                                      jalon_model** out);

/**
 * A street of mobile mapping and the drive through it, without error: in an L or straight ("corner"). To either side
 * of a leg stand blocks of four houses, four blocks outside of the corner and three inside, 3 m short of the next;
 * fronts are set back 0, 0.3 ... 1.2 m from a line 8 m from the axis, and turned by up to 0.05 rad. Fronts alone, or
 * whole houses with ground and things that a building model lacks ("closed"). options: operation "street_drive".
 *
 * - model: parts of classes building, ground, element; may be NULL.
 * - trajectory: with sigmas, axes "enu"; may be NULL.
 */
JALON_API JALON_CHECK jalon_status jalon_scene_street_drive(const jalon_params* options,
                                                            jalon_model** model,
                                                            jalon_trajectory** trajectory);

/**
 * A drive through that street as a user has it and as it was: the five scenarios of Monnier (2014) for the adjustment
 * of trajectory and model together (jalon/adjustment.h). options: operation "drive_scenario".
 *
 * - scenario: standard deviations of blocks, facades, strips and trajectory: 1: 0.01, 0.01, 0.01, 2 m; 2: 2, 0.01,
 *   0.01, 0.01; 3: 0.01, 2, 0.01, 0.01; 4: 0.01, 0.01, 2, 0.01; 5: 1, 0.5, 0.3, 1; 0: by "sigma_block_m" ... The
 *   errors are a draw of them ("seed"): of blocks, facades and strips independent, of the trajectory Gauss-Markov
 *   from one control time to the next and linear between.
 * - model, true_model: strips; with roofs and ground as well where the street is "closed". Then things stand before
 *   the houses that the model does not know.
 * - trajectory, true_trajectory: with the sigmas of the scenario, axes "enu".
 * - cloud: as jalon_scanner_drive gives it from the true trajectory, points and beams where the wrong one puts them.
 *
 * Each output may be NULL.
 */
JALON_API JALON_CHECK jalon_status jalon_scene_drive_scenario(const jalon_params* options,
                                                              jalon_task* task, jalon_model** model,
                                                              jalon_trajectory** trajectory,
                                                              jalon_cloud** cloud,
                                                              jalon_model** true_model,
                                                              jalon_trajectory** true_trajectory);

/**
 * The scanner that goes with a scene: method "static" with stations, field of view, steps, noise,
 * misfit, beam and glass as the seed and the options of the scene "grammar" have them. Of other
 * scenes one without stations, with the defaults. options may be NULL for the default scene.
 */
JALON_API JALON_CHECK jalon_status jalon_scene_scanner(const jalon_params* options,
                                                       jalon_scanner** out);
/**
 * Writes what is true of the scene "grammar" and of a scan of it, as JSON.
 *
 * - scanner: the one of the scan, of method "static"; NULL or one without stations stands for the
 *   scene's own.
 * - options: those the model was made with; NULL stands for "grammar" with its defaults.
 *   Scene "yard" has another shape, below. JALON_ERROR_UNSUPPORTED for other scenes.
 *
 * An object with "shape" ("jalon facade truth 1"), "scene", "kind", "seed", "walls" and "openings".
 * A contour is a list of corners [u, v, sagitta]: metres along the wall and up; the sagitta of the
 * edge to the next corner is 0 for a straight one, else an arc, that bulges outward when positive;
 * counter-clockwise. Shares are from 0 to 1.
 *
 *     of a wall           meaning
 *     name                "wall 1", "wing 2", "dormer 3", ...
 *     origin              of its plane; with along, up and normal (out of the house) in the world
 *     outline             contour that walks round the openings at the wall's border
 *     covers              what lies flat on it (surrounds, panels, signs): outline and holes
 *     area_m2             openings and covers taken off
 *     seen_share          of that area: a beam reaches it
 *     hidden_share        of that area: every beam towards it ends before
 *     never_share         of that area: no station has a beam towards it
 *     raster              the same in cells of cell_m from low on, rows from below, a letter a
 *                         cell: s seen, h hidden, n never, c covered, o opening, . outside
 *
 *     of an opening       meaning
 *     wall                number of its wall, from 0
 *     class               window, door, gateway, shop_front, vent, other, recess
 *     contour             in the wall's plane
 *     depth_m             from the wall to what fills it; of a recess to its back wall
 *     storey              0: on the ground
 *     touches_ground      it stands on the ground
 *     touches_border      it is cut into the wall's outline
 *     outline_seen_share  of its edges without its foot on the ground: the wall beside is seen
 *     area_seen_share     of its area: beams reach the wall's plane there or go through
 *     spacing_m           of all stations' points on the wall's plane there; 0: none sees it
 *     width_spacings      the lesser of width and height in these spacings
 *
 * Of the scene "yard" an object with "shape" ("jalon coded truth 1"), "scene", "seed", "classes" (numbers and names),
 * "survey" and "targets" (lines ID;X;Y;Z;code in the world's coordinates), and "face_classes": the class of each face
 * id, from 1 on; faces with larger ids are of class 0.
 */
JALON_API JALON_CHECK jalon_status jalon_scene_write_truth(const char* path,
                                                           const jalon_scanner* scanner,
                                                           const jalon_params* options,
                                                           jalon_task* task);

JALON_END_C

#endif
