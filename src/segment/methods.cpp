// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/methods.h"

#include "base/names_of.h"
#include "segment/codes_methods.h"
#include "segment/growing_settings.h"
#include "segment/hough_settings.h"
#include "segment/profile_settings.h"
#include "segment/ransac_settings.h"
#include "segment/raster_settings.h"
#include "segment/scan_line_settings.h"
#include "segment/split_settings.h"
#include "segment/triangle_settings.h"

namespace jalon {

namespace {

template <class Settings, Segmentation (*Segment)(const CloudPtr&, const Settings&, Task&)>
Segmentation run(const CloudPtr& cloud, const ParamSet& params, Task& task) {
  return Segment(cloud, settings_from<Settings>(params), task);
}

constexpr SegmentMethod kMethods[] = {
    {"ransac", "segmenter ransac", ransac_rows, run<RansacSettings, segment_ransac>},
    {"region_growing", "segmenter region_growing", region_growing_rows,
     run<GrowingSettings, segment_region_growing>},
    {"raster_growing", "segmenter raster_growing", raster_growing_rows,
     run<RasterSettings, segment_raster_growing>},
    {"profiles", "segmenter profiles", profile_rows, run<ProfileSettings, segment_by_profiles>},
    {"triangle_growing", "segmenter triangle_growing", triangle_growing_rows,
     run<TriangleSettings, segment_triangle_growing>},
    {"split_merge", "segmenter split_merge", split_merge_rows,
     run<SplitSettings, segment_split_merge>},
    {"hough", "segmenter hough", hough_rows, run<HoughSettings, segment_hough>},
    {"scan_lines", "segmenter scan_lines", scan_line_rows,
     run<ScanLineSettings, segment_by_scan_lines>},
    {"survey_codes", "segmenter survey_codes", survey_code_rows,
     run<SurveyCodeSettings, segment_by_survey_codes>},
    {"target_codes", "segmenter target_codes", target_code_rows,
     run<TargetCodeSettings, segment_by_target_codes>},
};

}  // namespace

std::span<const SegmentMethod> segment_methods() { return kMethods; }
std::span<const char* const> segment_method_names() { return kNamesOf<kMethods>; }

}  // namespace jalon
