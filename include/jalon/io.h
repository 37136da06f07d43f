/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/**
 * @file io.h
 * Files. The format is told by content first and by extension second; paths are UTF-8. Text is read and written without
 * locale.
 *
 * Readers never trust a count in a header: memory grows with what has been read. A truncated or lying file is
 * JALON_ERROR_FORMAT, and the message names file, offset and reason. Writers write beside the target and rename: a
 * failed write never replaces a good file.
 *
 * LAZ, COPC and E57 are an optional component of the library (JALON_WITH_RUST_FORMATS): without it they are
 * JALON_ERROR_UNSUPPORTED, the message names what to install, and jalon_format_info tells no abilities of them.
 *
 * Clouds: LAS 1.0-1.4 (point formats 0-10; written as 1.2, with wave packets as 1.3, or as 1.4; VLRs, EVLRs and CRS
 * carried verbatim, so also the samples of wave packets inside the file, while a ".wdp" beside it is the caller's to
 * copy under the new name; other fields as extra bytes, with "_exact" behind the name where a standard dimension of
 * that name cannot hold the values; angles between the steps of a standard dimension are rounded there too), PLY
 * (ASCII, both endians, all scalar properties),
 * XYZ/TXT/CSV text, and
 *
 * - LAZ (laz), read and written: as LAS; its chunks are decoded and encoded on all threads.
 * - COPC (copc.laz), read and written: LAZ 1.4 of point formats 6-8 whose chunks are the nodes of an octree. Read whole
 *   it is LAZ, in the order of the file. With the options "box" and "spacing_m" only those pages of the hierarchy and
 *   chunks are read whose nodes the box touches, down to the first level whose points stand no wider apart than
 *   "spacing_m" (the spacing that the file tells, halved each level). The points are those of the whole file in that
 *   box and those levels, in its order. Written: the cube stands on the lowest corner of the points; each node keeps
 *   the point nearest to the centre of each cell of its grid of 128^3, a node of at most 10 000 points all of them, and
 *   the levels follow one another. A CRS is kept as in LAS; other programs want it as WKT, which UTM on WGS 84 and
 *   on ETRS89, Lambert-93 and CC42 to CC50 get from their EPSG code; of other codes a warning says that they have
 *   none. The same bytes for any number of threads.
 * - GeoTIFF (tif), written: a depth image as float32 metres, seen from "png_direction": from above the heights of
 *   the highest points in the cloud's own system (its EPSG code, where its unit is the metre), else x and y along the
 *   image.
 * - EPT (ept.json), read and written: Entwine Point Tile 1.0 in its binary form, a folder that the path of its
 *   ept.json names and that is made where there is none: the points of each node of the octree that COPC has as
 *   ept-data/D-X-Y-Z.bin, their numbers in ept-hierarchy. The data set appears whole, in place of an old one. Fields
 *   in their types under the names that readers know (Intensity, Classification, GpsTime, NormalX ...), other
 *   components by their number, with their extremes, mean and deviation; the CRS by EPSG code and WKT where its unit
 *   is the metre. Stations as in LAS, told by "jalon" in ept.json. The order is that of the nodes; the same bytes for
 *   any number of threads. Read: with "box" and "spacing_m" the nodes that the box touches, down to the first level
 *   whose points stand no wider apart; points as LAZ and a hierarchy as gzip are JALON_ERROR_UNSUPPORTED.
 * - E57 (e57), read and written: a station for each scan, points moved by its pose, those marked invalid left out.
 *   Fields row and column (uint32), intensity (float32), red, green, blue (uint8, or uint16 where a scan has more than
 *   255), return_number (from 1), number_of_returns, time (s), normal, and those of extensions in the smallest type
 *   that holds them. Written: a scan for each station and one for points of none, coordinates as float64 or in steps of
 *   "scale"; other fields in the extension "jalon", their names as XML allows them.
 * - PTX (ptx), read: a station for each scan; points are moved by its matrix. Fields row and column (uint32, from 0, as
 *   the file counts), intensity (float32), red, green, blue (uint8). Beams without return ("0 0 0") are no points:
 *   their cells of the grid stay empty. A matrix that is no rotation within 1e-3 moves the points and gives no pose.
 * - PTS (pts), read and written as text: x y z, with intensity, with colours, or with both; several blocks are
 *   stations without pose; a count that lies gives a warning.
 * - PCD (pcd), read (ASCII, binary, binary_compressed) and written (binary, coordinates float64). Packed "rgb" and
 *   "rgba" are red, green, blue (and alpha), normal_x normal_y normal_z the field "normal"; a VIEWPOINT other than the
 *   origin is the one station, and that of a cloud with one is written. Of an organised cloud (HEIGHT above 1) cells
 *   that are not finite are no points; the others have row and column.
 *
 * Stations travel with the points: E57, PTX and (one) PCD have a place for them, and what others lack is written and
 * read as one JSON text, of which ranges of points or the values of a field tell which points are whose:
 *
 *     {"jalon_stations": 1, "points": 5000, "stations": [
 *       {"name": "west", "first": 0, "count": 3000, "pose": [1, 0, 0, 12.5, 0, 1, 0, -3, 0, 0, 1, 1.7]},
 *       {"name": "east", "first": 3000, "count": 2000}]}
 *     {"jalon_stations": 1, "field": "scan", "stations": [{"name": "west", "value": 1, "position": [12.5, -3, 1.7]}]}
 *
 * "pose" has the first three rows of the matrix from the scanner to the points, row by row; "position" is of an upright
 * scanner; without either the pose is unknown. Ranges ascend and do not overlap; "points", where it is there, must be
 * the number of the points. Lengths are in the file's unit. It stands
 *
 * - in LAS and LAZ as the data of VLRs of the user "Jalon" with the number 1, and the field that it names is an extra
 *   dimension with the number of each point's station, "station": uint8 or uint16, 0 = none. So the stations survive
 *   programs that keep records and dimensions while they cut or sort the points. Several VLRs share many stations. The
 *   dimension is no field of the cloud read.
 * - in PLY as comments "comment stations {...}", by ranges.
 * - else in a file beside the points, "scan.stations.json" beside "scan.xyz", with "file" = the name of the points'
 *   file; it may be written by hand, without "file", for any format that told no stations (of LAS in metres). Writing
 *   the points again replaces it, or takes it away where the cloud has no stations.
 *
 * Where the field is not in runs the points are put in the order of their stations, which a warning says. What is
 * broken or does not fit the points is a warning, and the cloud has no stations.
 *
 * Models; coordinates are those of the model, in metres (extensions in brackets):
 *
 * - DXF (dxf), read: a part for each layer, with its class where the layer is named like ours; closed polylines with
 *   their arcs and circles as faces; 3DFACE, SOLID, MESH, polygon and polyface meshes as triangles, or as faces
 *   ("polygons" = "faces"); blocks where they are inserted. Rings of our own drawings are outlines and holes again,
 *   with their parts. Metres by $INSUNITS or "unit"; entities that bound no surface are counted in the log; binary
 *   files and DWG are JALON_ERROR_UNSUPPORTED.
 *   Written: AutoCAD 2000 (AC1015, with handles, tables, layouts and metres as its unit) or release 12
 *   (AC1009). A layer for each class of part (WALL, WINDOW, DOOR, GATEWAY ...), "-COPIED" behind copied elements'
 *   class, NO_DATA for areas that no station saw; each ring of a face is a closed polyline in the plane of the face,
 *   arcs are bulges (2 sagitta / chord) with the face's extrusion direction; triangles of a mesh are 3DFACEs.
 *   Application data (JALON) names face, part, class, evidence and depth. "dxf_view" = "elevation" draws the facades
 *   flattened, 1:1: x from the left end of the facade, y the height of the model; several facades stand side by side, 2
 *   m apart; faces seen edge-on are left out. "dxf_images" shows orthoimages of
 *   facades (jalon_report_write_orthoimage) in either view of AutoCAD 2000: a link to each file, in its place.
 * - CityJSON 2.0 (city.json, json), written and read (1.0 and 1.1 too): a Building for each part of that class, with a
 *   MultiSurface, and a Solid for each solid; semantic surfaces WallSurface, Window and Door (children of the wall
 *   whose hole they fill), ClosureSurface (other openings), RoofSurface, GroundSurface. A window of which the
 *   hole alone is known gets a surface in the wall ("closes_opening"). Attributes carry name, class, evidence,
 *   copied_from, widths, sigma and the tree of parts, of an adjusted model also what moved each part (adjustment.h: not
 *   read back; nor are attributes of other programs); the CRS is written when it has an EPSG code and is metric.
 *   Coordinates are stored in steps of "city_scale_m". Read back: faces, holes, parts, solids, CRS; of several levels
 *   of detail the highest; geometry templates are JALON_ERROR_UNSUPPORTED.
 * - GeoJSON (geojson), written: a Feature for each face and each opening without one, 3D positions in the model's own
 *   system, which the member "crs" names (a local one in metres when it is not known: the numbers are never degrees).
 * - glTF 2.0 (glb), written: a node for each part with name, and class, evidence and measures as "extras"; faces as
 *   triangles in the colour of their class, openings that are holes as outlines. Coordinates are float32 from a whole
 *   metre that the root node's matrix and its "origin_m" tell.
 * - IFC4 (ifc), written: project, site, buildings with a storey each; IfcWall with IfcOpeningElements that void it,
 *   IfcWindow and IfcDoor that fill those with the joinery measured in them, IfcRoof, terrain, all else as proxies
 *   of its class; facades as IfcGroups. Walls are the measured surfaces with their holes, or, with
 *   "ifc_wall_thickness_m", solids behind them that the openings cut. The property set "Jalon_Precision" has evidence,
 *   confidence, sigma and measures, "Jalon_Measured" area and volume. A CRS with an EPSG code in metres becomes the map
 *   conversion. Equal models give equal bytes.
 * - GeoPackage 1.3 (gpkg), written by a library with SQLite (else JALON_ERROR_UNSUPPORTED): layers "faces" and
 *   "openings" (polygons in space), "elevation" (the facades unrolled side by side as in "dxf_view" = "elevation", z
 *   before their front, openings behind the faces), "plan" (upright faces as lines where they are cut
 *   "gpkg_plan_height_m" above the foot of their facade, and the openings in their gaps), "mesh" (triangles of no
 *   face). Columns tell class, name, facade, evidence, confidence, measures, area, sigma and normal. The srs_id is the
 *   EPSG code of the CRS, 100000 for another WKT 1 in metres, else -1: a local Cartesian system. Equal models give
 *   equal bytes. The file is made in memory.
 * - OBJ (obj), written and read: faces as polygons and triangles, openings stay open; outlines as lines; the tree of
 *   parts in comments that other programs pass over, so that our own files come back with faces, holes, parts and
 *   solids. Files of others are meshes with groups as parts, or a face for each polygon ("polygons" = "faces").
 * - STL (stl), written and read: triangles; binary (float32; large coordinates less whole metres, which the header
 *   names) or ASCII (exact; a solid for each part).
 * - PLY (ply), written as triangles and read as a mesh.
 *
 * Where a format knows no arcs, chords at most "chord_error_m" (1 mm) from the arc stand for them, the same ones in all
 * faces that share it.
 */
#ifndef JALON_IO_H
#define JALON_IO_H

#include <jalon/cloud.h>
#include <jalon/model.h>

JALON_BEGIN_C

/** Reads a cloud. options: operation "read" (columns, drop_invalid, box, ...) or NULL. A "box" leaves the points inside
 * of any format; "spacing_m" of a file without levels is JALON_ERROR_UNSUPPORTED. */
JALON_API JALON_CHECK jalon_status jalon_cloud_read(const char* path, const jalon_params* options,
                                                    jalon_task* task, jalon_cloud** out);
/** Writes a cloud in the format of the extension. options: operation "write" or NULL. */
JALON_API JALON_CHECK jalon_status jalon_cloud_write(const jalon_cloud* cloud, const char* path,
                                                     const jalon_params* options, jalon_task* task);
/** Reads a cloud from one file and writes it to another, as jalon_cloud_read and jalon_cloud_write would, to the same
 * bytes. options: operation "convert" (box, columns, scale, ...) or NULL. *out is the number of points written. From
 * LAS, LAZ, COPC and text (from 256 MiB on) without stations to LAS, LAZ and text the points go through in pieces of
 * half a million, so that the memory needed does not grow with the file; text, and with "scale" any file, is read more
 * than once for that. Other pairs, a file written over itself, text with a coordinate that is not finite, and files in
 * which one piece settles what another cannot keep are read whole. The target appears when all is written. */
JALON_API JALON_CHECK jalon_status jalon_cloud_convert(const char* source, const char* target,
                                                       const jalon_params* options,
                                                       jalon_task* task, uint64_t* out);
/** Reads a mesh or model: CityJSON, DXF, OBJ, STL or PLY with faces. */
JALON_API JALON_CHECK jalon_status jalon_model_read(const char* path, const jalon_params* options,
                                                    jalon_task* task, jalon_model** out);
/** Writes a model in the format of the extension: one of those above that are written of models. options: operation
 * "write" (dxf_version, dxf_view, chord_error_m ...) or NULL. */
JALON_API JALON_CHECK jalon_status jalon_model_write(const jalon_model* model, const char* path,
                                                     const jalon_params* options, jalon_task* task);
/** Number of formats in the registry. */
JALON_API JALON_CHECK jalon_status jalon_format_count(uint64_t* out);
/** Format i: name ("LAS"), extensions ("las"), and what it can do as text, e.g. "cloud read write". Each output may be
 * NULL. */
JALON_API JALON_CHECK jalon_status jalon_format_info(uint64_t i, const char** name,
                                                     const char** extensions,
                                                     const char** abilities);

JALON_END_C

#endif
