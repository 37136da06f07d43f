# SPDX-FileCopyrightText: 2026 The Jalon authors
# SPDX-License-Identifier: Apache-2.0
"""What the C declarations leave unsaid: what counts an array, what may be NULL, whose options they are.

The headers say it in words; here it stands once for programs: the bindings take it (shapes.py), and
so does the test that calls every function with NULL and wild values (tests/abi/null_wild.py). Names
are parameters, wherever they occur, or "function.parameter" for one place alone.
"""

# ---- arrays --------------------------------------------------------------------------------------

# Arrays and the parameter that counts their items.
ARRAYS = {
    "xyz": "count", "x": "count", "y": "count", "z": "count",
    "data": "count", "values": "count", "indices": "count", "names": "count",
    "queries": "count", "seeds": "count", "picks": "count", "places": "count",
    "alignment": "alignment_count", "polygon_uv": "count", "clouds": "count", "probabilities": "count",
    "vertices": "count_vertices", "triangles": "count_triangles",
    "pieces": "piece_count", "hull_points": "hull_point_count", "poses": "pose_count",
    "reference": "reference_count", "moving": "moving_count",
    "automatic_rings": "automatic_ring_count", "reference_rings": "reference_ring_count",
    "automatic_uv": "automatic_ring_count", "reference_uv": "reference_ring_count",
    "automatic_m2": "count", "reference_m2": "count", "intersection_m2": "count",
    "automatic_xyz": "count", "reference_xyz": "count",
    "ranges_m": "count", "measured_m": "count", "known_m": "count",
    "times_s": "count", "thetas_rad": "count", "phis_rad": "count", "positions_m": "count", "attitudes_rad": "count", "wavelengths_m": "count", "remainders_m": "count", "bytes": "byte_count",
}
# With those that may be NULL beside an array of the same count.
COUNTS = {
    **ARRAYS, "position_sigmas_m": "count", "velocity_sigmas_m_s": "count", "attitude_sigmas_rad": "count", "face_ids": "count_triangles", "vertical_rad": "count", "incidence_rad": "count",
}
# Elements an item, of packed arrays whose items are more than one.
ROWS = {
    "alignment": 3, "xyz": 3, "queries": 3, "picks": 3, "places": 3, "vertices": 3, "triangles": 3,
    "hull_points": 3, "automatic_xyz": 3, "reference_xyz": 3, "positions_m": 3, "attitudes_rad": 3,
    "position_sigmas_m": 3, "velocity_sigmas_m_s": 3, "attitude_sigmas_rad": 3,
    "polygon_uv": 2, "automatic_uv": 2, "reference_uv": 2,
}
# Arrays whose number of items no parameter tells: they must hold what the rings say.
BY_RINGS = {"automatic_uv": "automatic_rings", "reference_uv": "reference_rings"}

# ---- outputs -------------------------------------------------------------------------------------

# Types of parameters that are written on success; pointers to handles (jalon_cloud**) are too.
OUTPUTS = (
    "uint64_t*", "int64_t*", "int32_t*", "uint32_t*", "double*", "float*", "void*",
    "const char**", "const double**", "const char*const**",
    "jalon_box*", "jalon_vec3*", "jalon_transform*", "jalon_array_view*", "jalon_reduction*",
)
# The same, of structs whose struct_size the caller sets before.
SIZED_OUTPUTS = ("jalon_field_info*", "jalon_param_info*")

# ---- NULL ----------------------------------------------------------------------------------------

# Parameters that the headers let be NULL.
NULLABLE = {
    # inputs
    "task", "options", "method", "other", "user", "callback",
    "pose", "origin", "covariance", "T_box_world", "T_prism_world",
    "alignment", "unit", "meaning", "notes_json", "sigma_path",
    "face_ids", "places", "vertical_rad", "incidence_rad",
    "position_sigmas_m", "velocity_sigmas_m_s", "attitude_sigmas_rad",
    # outputs that a caller may leave aside
    "report", "outside", "interest", "unwanted", "centroid", "edge_m",
    "classes", "totals", "out_summary", "out_cells",
    "near_points", "near_faces", "intervals",
    "rows", "bins", "density", "cumulative",
    # in one place
    "jalon_comparison_regions.out_points", "jalon_comparison_regions.out_regions",
    "jalon_comparison_diagnose.out_forward", "jalon_comparison_diagnose.out_reverse",
    "jalon_comparison_diagnose.out_changes",
    "jalon_comparison_outlines.reverse", "jalon_comparison_outlines.changes",
    "jalon_model_clearance.summary", "jalon_model_clearance_to_model.summary",
    "jalon_gauge_sweep.cloud", "jalon_gauge_sweep.model",
    "jalon_gauge_sweep_model.cloud", "jalon_gauge_sweep_model.model",
    "jalon_cloud_station.name", "jalon_cloud_station.has_pose", "jalon_cloud_station.first",
    "jalon_cloud_station.count",
    "jalon_cloud_split.equal", "jalon_cloud_split.others",
    "jalon_cloud_field_histogram.law", "jalon_cloud_field_histogram.summary",
    "jalon_format_info.name", "jalon_format_info.extensions", "jalon_format_info.abilities",
    "jalon_model_part.name", "jalon_model_part.part_class", "jalon_model_part.parent",
    "jalon_model_rename_part.name", "jalon_model_rename_part.part_class",
    "jalon_registrar_run.start",
    "jalon_report_write_html.model", "jalon_report_write_json.model",
    "jalon_report_write_comparison.reverse", "jalon_report_write_comparison.changes",
    "jalon_report_write_adjustment.truth", "jalon_report_write_clearance.cloud",
    "jalon_report_write_clearance.gauge", "jalon_report_write_clearance.model",
    "jalon_report_write_registration.reference", "jalon_report_write_registration.moving",
    "jalon_trajectory_create.crs",
    "jalon_model_building_strips.model", "jalon_model_building_strips.strips",
    "jalon_model_perturb_strips.model", "block_offsets", "facade_offsets", "strip_offsets",
    "jalon_scene_street_drive.model", "jalon_scene_street_drive.trajectory",
    "jalon_scene_drive_scenario.model", "jalon_scene_drive_scenario.trajectory", "jalon_scene_drive_scenario.cloud",
    "true_model", "true_trajectory",
    "jalon_scanner_add_station.name", "jalon_scanner_truth.cloud", "jalon_scene_write_truth.scanner",
    "jalon_cloud_knn.squared_distances",
    "jalon_cloud_depth_map.columns",
}
# Places where a name of NULLABLE may not be NULL.
NOT_NULLABLE = {"jalon_report_write_clearance.places", "jalon_report_write_clearance.intervals",
                "jalon_model_clearance_to_model.other", "jalon_scanner_add_station.pose"}
# Parameters of which the headers leave it open: with NULL the call succeeds or is refused.
OPEN = {
    "inside", "crs", "jalon_comparison_outlines.reverse_points",
    "jalon_cloud_builder_begin_station.name", "jalon_cloud_set_station.name",
    "jalon_cloud_fit_cylinder.direction",
    "jalon_cloud_knn_all.squared_distances",
    "jalon_cloud_radius_search.ranges", "jalon_cloud_radius_search.neighbours",
    "jalon_report_write_elevation.model", "jalon_report_write_elevation.options",
    "jalon_network_adjust.points",
}
# Those of OPEN where the headers say what NULL stands for: the bindings let them be left out.
MAY_BE_LEFT_OUT = {"jalon_cloud_fit_cylinder.direction", "jalon_comparison_outlines.reverse_points"}


def says(names, function, parameter):
    """Whether one of those sets names the parameter of that function."""
    return parameter in names or function + "." + parameter in names


# ---- parameter sets ------------------------------------------------------------------------------

# The JALON_PARAM_ type of the row that a typed function of jalon_params works on.
TYPED = {
    "set_double": 1, "get_double": 1, "set_int64": 2, "get_int64": 2, "set_bool": 3, "get_bool": 3,
    "set_string": 4, "get_string": 4, "set_doubles": 6, "get_doubles": 6,
}
# The operation whose parameters the argument "options" holds, in the order of the headers.
OPERATION = {
    "jalon_comparison_regions": "regions",
    "jalon_comparison_diagnose": "diagnosis",
    "jalon_comparison_outlines": "change_outlines",
    "jalon_model_clearance": "clearance",
    "jalon_model_clearance_to_model": "clearance",
    "jalon_gauge_sweep": "clearance",
    "jalon_gauge_sweep_model": "clearance",
    "jalon_cloud_compute_normals": "normals",
    "jalon_cloud_compute_features": "features",
    "jalon_cloud_compute_components": "components",
    "jalon_cloud_remove_outliers": "outliers",
    "jalon_cloud_subsample": "subsample",
    "jalon_cloud_split_interest": "interest",
    "jalon_segmentation_from_labels": "labels",
    "jalon_segmentation_evaluate": "evaluation",
    "jalon_cloud_confusion": "confusion",
    "jalon_model_evaluate": "model_evaluation",
    "jalon_area_indices": "indices",
    "jalon_polygon_indices": "indices",
    "jalon_noise_law_fit": "noise_law",
    "jalon_cloud_field_histogram": "histogram",
    "jalon_cloud_compute_chi_square": "chi_square",
    "jalon_cloud_classify_field": "classes",
    "jalon_cloud_compute_gradient": "gradient",
    "jalon_cloud_filter_field": "field_filter",
    "jalon_cloud_compute_field": "field_arithmetic",
    "jalon_cloud_compute_geodesic": "geodesic",
    "jalon_cloud_segment_propagation": "propagation",
    "jalon_cloud_compute_map_distance": "distance_map",
    "jalon_cloud_distance_map": "distance_map",
    "jalon_cloud_read": "read",
    "jalon_cloud_write": "write",
    "jalon_cloud_convert": "convert",
    "jalon_model_read": "read",
    "jalon_model_write": "write",
    "jalon_precision_budget": "precision",
    "jalon_cloud_compute_covariances": "precision",
    "jalon_segmentation_plane_covariances": "precision",
    "jalon_cloud_fit_sphere": "primitive",
    "jalon_cloud_fit_cylinder": "primitive",
    "jalon_cloud_fit_circle": "primitive",
    "jalon_segmentation_pick": "pick",
    "jalon_report_write_elevation": "elevation",
    "jalon_report_write_picture": "picture",
    "jalon_report_write_orthoimage": "orthoimage",
    "jalon_report_write_html": "report",
    "jalon_report_write_json": "report",
    "jalon_report_write_deviations": "deviation_picture",
    "jalon_report_write_histogram": "comparison_report",
    "jalon_report_write_comparison": "comparison_report",
    "jalon_report_write_clearance": "clearance_report",
    "jalon_report_write_registration": "registration_report",
    "jalon_report_write_adjustment": "adjustment_report",
    "jalon_scene_create": "scene",
    "jalon_scene_scanner": "scene",
    "jalon_scene_write_truth": "scene",
    "jalon_cloud_measure_targets": "target",
    "jalon_cloud_compute_visibility": "visibility",
    "jalon_cloud_depth_map": "visibility",
    "jalon_cloud_write_depth_map": "visibility",
    "jalon_cloud_volume": "volume",
    "jalon_model_volume": "volume",
    "jalon_model_sample": "model_sample",
    "jalon_cloud_sections": "sections",
    "jalon_sections_write": "write",
    "jalon_model_relations": "relations",
    "jalon_segmentation_long_edges": "long_edges",
    "jalon_trajectory_create": "trajectory",
    "jalon_trajectory_read": "trajectory_file",
    "jalon_trajectory_georeference": "georeference",
    "jalon_trajectory_adjust": "adjust",
    "jalon_network_adjust": "network",
    "jalon_scene_drive_scenario": "drive_scenario",
    "jalon_cloud_ellipsoids": "ellipsoids",
    "jalon_normality": "normality",
    "jalon_model_building_strips": "building_strips",
    "jalon_model_perturb_strips": "building_sigmas",
    "jalon_scene_street_drive": "street_drive",
    "jalon_cloud_field_normality": "normality",
    "jalon_trajectory_write": "trajectory_file",
}
