/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file comparer.h
 * Comparison: a reference (cloud or model) and a compared cloud in; a distance a point, what became of each point, and
 * the changes out. A comparison has a direction: its rows belong to the compared points and tell how far these are
 * from the reference (Girardeau-Montaut 2006, chapters 2 and 3).
 *
 * A comparer holds parameters and no data; one thread at a time sets them, several may run it once set. A comparison is
 * immutable, retains the points its rows belong to, and may be read by many threads.
 */
#ifndef JALON_COMPARER_H
#define JALON_COMPARER_H

#include <jalon/cloud.h>
#include <jalon/model.h>

JALON_BEGIN_C

typedef struct jalon_comparer jalon_comparer;
typedef struct jalon_comparison jalon_comparison;

/** What became of a compared point; 0 to 3 are the labels of the visibility test, the best known first. */
enum {
  JALON_COMPARED = 0,      /**< it has a distance */
  JALON_HIDDEN = 1,        /**< behind what the reference's scanners saw */
  JALON_OUT_OF_RANGE = 2,  /**< farther than they reach */
  JALON_OUT_OF_FIELD = 3,  /**< outside their field of view */
  JALON_NOTHING_NEAR = 4,  /**< no reference within max_distance_m */
  JALON_TOO_FEW_POINTS = 5 /**< too few points around it for a value */
};

/** Why two clouds hardly share a place, or less than they could, as far as it shows. */
enum {
  JALON_APART_UNKNOWN = 0, /**< nothing that is known brings them together, or they are together */
  JALON_APART_AXES = 1,    /**< axes swapped or turned round */
  JALON_APART_UNIT = 2,    /**< another unit of length */
  JALON_APART_ORIGIN = 3,  /**< the same extent elsewhere: another origin or CRS */
  JALON_APART_DEGREES = 4  /**< one is in degrees of longitude and latitude */
};

/**
 * How much of two clouds lies at the same place, before they are compared, and why hardly any does. By cells of a
 * hundredth of the smaller cloud's diagonal, or as large as hold four points in the mean. Nothing is shared by, and no
 * gap told of, an empty cloud, which is not called apart. O(n) for the boxes, the rest by 50 000 points of each.
 * Clouds about one origin share a place whatever their units and axes are: of those that are not apart a cause is told
 * where it brings twice as many of their cells together and boxes of two sizes to one; so mirrored ones have none.
 *
 * One row:
 *     column           type         unit  meaning
 *     reference_share  float64      1     of the cells with points, at or beside such of the other
 *     compared_share   float64      1     the same of the compared cloud
 *     gap              float64      m     between the boxes; 0 where they meet
 *     apart            uint8        -     1 = both shares are below 0.05: they hardly share a place
 *     cause            uint8        -     JALON_APART_UNKNOWN ...
 *     axes             int8 x 3     -     JALON_APART_AXES: axes of the compared cloud, 1 ... 3,
 *                                         negative where turned round, that are the reference's
 *                                         x, y, z; else 1 2 3
 *     factor           float64      1     JALON_APART_UNIT: of the compared cloud's coordinates;
 *                                         else 1
 *     shift            float64 x 3  m     JALON_APART_ORIGIN: of the compared cloud onto the
 *                                         reference, roughly; else 0
 */
JALON_API JALON_CHECK jalon_status jalon_cloud_overlap(const jalon_cloud* reference,
                                                       const jalon_cloud* compared,
                                                       jalon_task* task, jalon_fields** out);

/**
 * method, NULL = "distance":
 * - "distance": from each compared point to the nearest of the reference: point of a cloud
 *   (Girardeau-Montaut 2006, 2.3.1), or a local surface through the reference points around that
 *   (parameter "local_model", 2.3.2); face or triangle of a model (2.2; jalon_comparer_run_model).
 *   Exact, a local surface to the cube's edge / 2^31; O(n log n).
 * - "m3c2": at core points the distance between two clouds along the local normal, compared minus
 *   reference, with its level of detection (Lague, Brodu & Leroux 2013): normals of the points
 *   within normal_radius_m; the points of both clouds in a cylinder along the normal; the surfaces
 *   they lie on; their medians or means. O(n log n + c m), c core points with m points around each.
 * - "preview": a quick look, cell by cell of one octree around both clouds: one value for all
 *   compared points of a cell (Girardeau-Montaut et al. 2005, 3.2). Rough at the borders of cells;
 *   points of cells without any reference have the status JALON_NOTHING_NEAR. With "measure" =
 *   plane_angle it gives angles in the place of distances. O(n log n).
 * - "landslide": what a slope lost and gained, cell by cell across it, with standard deviations, and
 *   what was not measured (Girardeau-Montaut 2006, 5.4). Zones that moved are found by the whole
 *   slope's tests, of one sign each; jalon_comparison_regions measures them,
 *   jalon_comparison_outlines draws their boundaries and the ground that neither or only one epoch
 *   has measured. No such ground is filled in. Plants count as ground: take them out first. Of
 *   upright scarps half in shadow the volume is too small, by more than its sigma tells. The rows
 *   are the cells, the points of the comparison their middles. O(n log n).
 */
JALON_API JALON_CHECK jalon_status jalon_comparer_create(const char* method, jalon_comparer** out);
/** The names of the methods, the default first. Static texts. */
JALON_API JALON_CHECK jalon_status jalon_comparer_methods(const char* const** names,
                                                          uint64_t* count);
/** A comparer of its own of the same method, with the same values. */
JALON_API JALON_CHECK jalon_status jalon_comparer_copy(const jalon_comparer* comparer,
                                                       jalon_comparer** out);
JALON_API jalon_comparer* jalon_comparer_retain(jalon_comparer* comparer);
JALON_API void jalon_comparer_release(jalon_comparer* comparer);
/** The comparer's own parameter set: setting it changes the comparer. The caller releases it. */
JALON_API JALON_CHECK jalon_status jalon_comparer_params(jalon_comparer* comparer,
                                                         jalon_params** out);
/**
 * Compares a cloud with a reference cloud. JALON_ERROR_INSUFFICIENT_DATA when either is empty;
 * JALON_ERROR_INVALID_ARGUMENT when both have a CRS and these differ. Points without a value have the distance NaN and
 * a status that says why; when that is so for all of them, the call still succeeds.
 */
JALON_API JALON_CHECK jalon_status jalon_comparer_run(const jalon_comparer* comparer,
                                                      const jalon_cloud* reference,
                                                      const jalon_cloud* compared, jalon_task* task,
                                                      jalon_comparison** out);

/**
 * Compares a cloud with a reference model by method "distance"; other methods are
 * JALON_ERROR_UNSUPPORTED. A point's distance is that from the nearest face (its openings are open;
 * arcs are chords at most chord_error_m off) or from the nearest triangle of the mesh that stands
 * for no face. Triangles without area count as what is left of them, a segment or a point. Errors
 * as of jalon_comparer_run; JALON_ERROR_INSUFFICIENT_DATA too for a model without any surface.
 *
 * Distances are negative behind the surface, the side from which its corners run clockwise: the
 * inside of a closed mesh. At edges and corners the side is told by the angle-weighted
 * pseudo-normal (Baerentzen & Aanaes 2005), which is right all around a closed surface whose
 * triangles run one way around. Elsewhere the column "side" tells it: a point nearest to a border
 * of an open surface gets the side of the surface as continued, one nearest to where neighbouring
 * triangles run opposite ways around the side of the nearest of them.
 *
 * The columns are those of a comparison with a model, see jalon_comparison_points and
 * jalon_comparison_summary. Ties go to the first face, then to the first triangle.
 *
 * JALON_ERROR_UNSUPPORTED for parameters that a model has no answer to: visibility, local_model,
 * sampling_error, hausdorff.
 *
 * O((n + m) log m) for n points and m triangles; about 120 B a triangle while it runs. To compare a
 * model with a model, take points on one of them with jalon_model_sample.
 */
JALON_API JALON_CHECK jalon_status jalon_comparer_run_model(const jalon_comparer* comparer,
                                                            const jalon_model* reference,
                                                            const jalon_cloud* compared,
                                                            jalon_task* task,
                                                            jalon_comparison** out);
/**
 * As jalon_comparer_run, at given core points: the places where distances are measured, of any origin; the rows of the
 * comparison are theirs. Method "m3c2"; others are JALON_ERROR_UNSUPPORTED.
 */
JALON_API JALON_CHECK jalon_status jalon_comparer_run_core(
    const jalon_comparer* comparer, const jalon_cloud* reference, const jalon_cloud* compared,
    const jalon_cloud* core, jalon_task* task, jalon_comparison** out);

/**
 * Sets the parameters of method "m3c2" (others: JALON_ERROR_UNSUPPORTED) from a parameter file of CloudCompare's M3C2
 * plug-in: key=value lines, M3C2VER among them. Its scales are diameters and become radii (NormalScale, SearchScale,
 * NormalMinScale ...); SearchDepth is max_depth_m, SubsampleRadius core_spacing_m (the edge of a cell instead of a
 * least distance), NormalPreferedOri 0 to 5 the axes +x -x +y -y +z -z (CloudCompare 2.10 and later), 11 the station.
 * The parameter "surfaces" becomes "all", what that program does. Parameters whose keys are absent stay.
 *
 * A key that is not known is a warning in the task's log. A setting that would change the distances and has no
 * counterpart (PositiveSearchOnly, UsePrecisionMaps, other NormalPreferedOri) is JALON_ERROR_UNSUPPORTED; a file of
 * another kind or with a value that is no number JALON_ERROR_FORMAT; the parameters are unchanged then.
 */
JALON_API JALON_CHECK jalon_status jalon_comparer_read_m3c2_file(jalon_comparer* comparer,
                                                                 const char* path,
                                                                 jalon_task* task);

JALON_API jalon_comparison* jalon_comparison_retain(jalon_comparison* comparison);
JALON_API void jalon_comparison_release(jalon_comparison* comparison);
/**
 * One row a point; of method "m3c2" a core point. Every method:
 *     column    type     unit  meaning
 *     distance  float64  m     from the reference; NaN without a value
 *     status    uint8    -     JALON_COMPARED ...
 *
 * Method "distance" with a cloud, the columns behind "nearest" by its parameters:
 *     column             type     unit  meaning
 *     nearest            uint32   -     the nearest reference point, of equally near ones the
 *                                       first; UINT32_MAX = none
 *     difference_x       float64  m     "differences", also with a model: from the foot on the
 *                                       reference to the point
 *     difference_y       float64  m     the same
 *     difference_z       float64  m     the same
 *     sampling_error     float32  m     "sampling_error": root mean square distance that the
 *                                       sampling of the reference around it would make on an
 *                                       unchanged plane (2.5 of the source)
 *     reference_spacing  float32  m     "reference_spacing", with visibility: of the reference's
 *                                       points, along grazing rays, across edges
 *     level_of_detection float32  m     "detection": 95 %, of the surface about the point by noise,
 *                                       spacing and shape; NaN: no surface of the reference there
 *     significant        uint8    -     "detection": 1 = changed, many tests at once accounted for
 *     evidence           uint8    -     "detection", of a change: 1 a surface that both clouds saw
 *                                       moved, 2 the reference saw through the place or, without
 *                                       stations, has nothing near; else 0
 *     recovered          uint8    -     "hidden" other than leave: JALON_NOT_RECOVERED ...
 *     height             float64  m     "hidden" = vertical: of a hidden point over the reference's
 *                                       surface
 *     shape_residual     float64  m     "hidden" = occluders: of its zone after a rigid fit to what
 *                                       hides it
 *
 * With "visibility" = stations points that the reference's scanners could not have seen (see
 * visibility.h) have no distance. "found": the same, and where points have no station those count
 * that the order of upright sweeps tells; where it tells none, as "none".
 *
 * With "detection" planes through 32 neighbouring points of both clouds are tested against each
 * other, one for every 16 points: sigma from their scatter, from the lever of the reference's
 * plane, from what scatters more than the noise and so does not average out, and from
 * "alignment_sigma_m"; the spread that most of the scene shares is no change (empirical null, Efron
 * 2004); significant at "false_discovery_rate" (Benjamini & Hochberg 1995), by at least three
 * planes side by side, and beside them what exceeds its own level of detection. Where the reference
 * has no such surface within the reach of its points, its stations decide: seen through is a
 * change, hidden or never looked at has the status hidden. Without stations what goes on beyond the
 * border of a surface is hidden, other places are changes: shadows may be among them. Needs
 * clouds that overlap for the most part and lie in one system. O(n log n).
 *
 * Method "distance" with a model:
 *     column            type    unit  meaning
 *     face              uint32  -     row of jalon_model_faces; UINT32_MAX = a triangle of the mesh
 *     triangle          uint32  -     row of jalon_model_triangles; UINT32_MAX = a face
 *     part              uint32  -     row of jalon_model_parts; UINT32_MAX = none
 *     side              uint8   -     signed distances: 0 certain, 1 at a border, 2 inconsistent
 *     within_tolerance  uint8   -     tolerance_m > 0: 1 yes, 0 no, 2 no distance
 *
 * Method "m3c2"; JALON_NOTHING_NEAR: one of the clouds has no point in the cylinder:
 *     column            type         unit  meaning
 *     lod               float64      m     level of detection: of unchanged places the share
 *                                          "confidence" has |distance| up to it
 *     significant       uint8        -     1 where |distance| > lod
 *     normal            float64 x 3  -     unit length; NaN where three points do not span a plane
 *     normal_radius     float64      m     of the ball that gave it; 0 if none
 *     count_reference   uint32       -     points of the reference surface compared
 *     count_compared    uint32       -     points of the compared surface
 *     spread_reference  float64      m     their standard deviation along the normal; with medians
 *                                          the interquartile range / 1.349
 *     spread_compared   float64      m     the same of the compared surface
 *
 * Method "landslide", one row a cell; "status" tells of the reference first why it has no distance, which is compared
 * above reference, along "direction":
 *     column            type     unit  meaning
 *     lod               float64  m     level of detection of the cell: of cells at rest the share
 *                                      "confidence" has |distance| up to it
 *     significant       uint8    -     1 = of a zone that moved
 *     zone              uint32   -     that zone, of one sign, 1 = most cells; 0 = none
 *     sigma             float64  m     of the distance, without what all cells share
 *     reference_status  uint8    -     JALON_COMPARED: measured; JALON_HIDDEN ... why not;
 *                                      JALON_NOTHING_NEAR: no point, though nothing hid it
 *     compared_status   uint8    -     the same of the compared epoch
 *     column            uint32   -     of the grid
 *     row               uint32   -     of the grid
 *     reference_points  uint32   -     points of the reference
 *     compared_points   uint32   -     points of the compared epoch
 *
 * Method "preview" with "measure" = plane_angle, in the place of "distance":
 *     column       type     unit  meaning
 *     plane_angle  float64  rad   between the planes of both clouds in the cell
 */
JALON_API JALON_CHECK jalon_status jalon_comparison_points(const jalon_comparison* comparison,
                                                           jalon_fields** out);
/**
 * One row. Every method:
 *     column          type     unit  meaning
 *     points          uint64   -     that were to be compared
 *     compared        uint64   -     points of this status
 *     hidden          uint64   -     points of this status
 *     out_of_range    uint64   -     points of this status
 *     out_of_field    uint64   -     points of this status
 *     nothing_near    uint64   -     points of this status
 *     too_few_points  uint64   -     points of this status
 *     mean            float64  m     of the compared points; NaN without any, as the next four
 *     rms             float64  m     about 0
 *     sigma           float64  m     about the mean
 *     minimum         float64  m     least distance
 *     maximum         float64  m     of unsigned distances the directed Hausdorff distance (2.2 of
 *                                    the source)
 *
 * Method "distance" with a cloud, by its parameters:
 *     column             type     unit  meaning
 *     sampling_rms       float64  m     "sampling_error": what sampling alone would make of rms
 *     sampling_mean      float64  m     and of mean
 *     hausdorff_forward  float64  m     "hausdorff", whatever max_distance_m: of the compared
 *                                       points from the reference points (2.3)
 *     hausdorff_reverse  float64  m     of the reference points from the compared points
 *     hausdorff          float64  m     the larger of both
 *     noise                 float64  m  "detection", as all to "stations": scatter about surfaces
 *     null_scale            float64  1  by which unchanged surfaces differ more than noise explains
 *     misalignment          float64  m  by which most surfaces differ beside noise, root mean
 *                                       square, which is in all levels of detection: epochs off
 *                                       by one motion (least absolute deviations; Koenker &
 *                                       Machado 1999) and stations registered no better (random
 *                                       effects; Paule & Mandel 1982, by the median)
 *     limit_sigmas          float64  1  beyond which a surface has moved
 *     false_discovery_rate  float64  1  as asked for
 *     tests                 uint64   -  surfaces that were tested
 *     stations              uint64   -  of the reference, told or found; 0: none
 *     modelled           uint64   -     "local_model": how many distances are to a local surface
 *                                       and not to a point
 *
 * Method "distance" with a model:
 *     column            type     unit  meaning
 *     maximum_absolute  float64  m     largest distance on either side
 *     at_border         uint64   -     signed distances: points whose side is that of the surface
 *                                      as continued
 *     inconsistent      uint64   -     signed distances: points near triangles that run opposite
 *                                      ways around
 *     within_tolerance  uint64   -     tolerance_m > 0: points at most that far from the model
 *     tolerance_share   float64  1     of the compared points
 *
 * Method "m3c2":
 *     column       type     unit  meaning
 *     significant  uint64   -     core points whose distance exceeds the level of detection
 *     mean_lod     float64  m     mean level of detection of the compared core points
 *
 * Method "landslide"; areas are across the direction, volumes those of measured cells alone:
 *     column                   type         unit  meaning
 *     significant              uint64       -     cells of zones that moved
 *     mean_lod                 float64      m     mean level of detection of the measured cells
 *     cell                     float64      m     side of the cells
 *     sigma_scale              float64      1     by which ground at rest differs more than its
 *                                                 points scatter
 *     systematic               float64      m     standard deviation of what whole blocks of cells
 *                                                 are off, by the ground at rest, with
 *                                                 "alignment_sigma_m"
 *     direction                float64 x 3  -     along which movements are counted
 *     along_columns            float64 x 3  -     from column to column
 *     first_cell               float64 x 3  m     centre of column 0 and row 0
 *     depletion                float64      m3    of the zones that went down
 *     depletion_sigma          float64      m3    its standard deviation
 *     accumulation             float64      m3    of the zones that rose
 *     accumulation_sigma       float64      m3    its standard deviation
 *     net                      float64      m3    accumulation less depletion
 *     net_sigma                float64      m3    its standard deviation
 *     depletion_area           float64      m2    of the zones that went down
 *     accumulation_area        float64      m2    of the zones that rose
 *     boundary                 float64      m     of all zones
 *     open_boundary            float64      m     of that, along ground that was not measured
 *     measured_area            float64      m2    that both epochs have measured
 *     unmeasured_reference     float64      m2    not measured in the reference alone
 *     unmeasured_compared      float64      m2    not measured in the compared epoch alone
 *     unmeasured_both          float64      m2    not measured in either
 *     unmeasured_hidden        float64      m2    of those in a shadow in an epoch at least
 *     unmeasured_beside_zones  float64      m2    of those what hangs together with the border of
 *                                                 a zone: the zone may go on there
 *     unmeasured_share         float64      1     of the whole area
 *
 * Method "preview" with "measure" = plane_angle, in the place of "mean" ... "maximum":
 *     column         type     unit  meaning
 *     angle_mean     float64  rad   of the angles between the planes
 *     angle_rms      float64  rad   about 0
 *     angle_sigma    float64  rad   about the mean
 *     angle_minimum  float64  rad   least angle
 *     angle_maximum  float64  rad   largest angle
 */
JALON_API JALON_CHECK jalon_status jalon_comparison_summary(const jalon_comparison* comparison,
                                                            jalon_fields** out);
/**
 * The check of a reference model part by part: one row a part of it (names: jalon_model_part), for
 * the points whose nearest surface is of the part. A comparison with a cloud, or with a model
 * without parts, has no columns here.
 *     column            type     unit  meaning
 *     part              uint32   -     row of jalon_model_parts
 *     points            uint64   -     whose nearest surface is of the part
 *     mean              float64  m     of their distances; NaN without points, as the next four
 *     sigma             float64  m     about the mean
 *     minimum           float64  m     least distance
 *     maximum           float64  m     largest distance
 *     maximum_absolute  float64  m     largest distance on either side
 *     within_tolerance  uint64   -     tolerance_m > 0: points at most that far away
 *     tolerance_share   float64  1     tolerance_m > 0: of the points
 */
JALON_API JALON_CHECK jalon_status jalon_comparison_parts(const jalon_comparison* comparison,
                                                          jalon_fields** out);
/** A new cloud handle: the points of the rows with the columns attached as fields, ready to be written; shares the
 * coordinates. */
JALON_API JALON_CHECK jalon_status jalon_comparison_cloud(const jalon_comparison* comparison,
                                                          jalon_cloud** out);
/**
 * The set of closest points: the reference points that are nearest to a point of the comparison, each once, in their
 * order, with their fields. reference: the cloud that the comparison (method "distance") was made with;
 * JALON_ERROR_NOT_FOUND for a comparison without "nearest", JALON_ERROR_INVALID_ARGUMENT for a cloud with fewer points
 * than it names.
 */
JALON_API JALON_CHECK jalon_status
jalon_comparison_closest_points(const jalon_comparison* comparison, const jalon_cloud* reference,
                                jalon_task* task, jalon_cloud** out);
/** The parameters the comparison was made with as JSON. Valid as long as the handle. */
JALON_API JALON_CHECK jalon_status jalon_comparison_parameters(const jalon_comparison* comparison,
                                                               const char** out);

JALON_END_C

#endif
