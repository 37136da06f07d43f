/* SPDX-FileCopyrightText: 2026 The Jalon authors
 * SPDX-License-Identifier: Apache-2.0 */
/* Seeds of what our own writers do not write: files as other programs make them, and texts given to functions. A
 * program that reads only what it wrote itself would never get to the other half of a reader. */
#include "seeds.h"

#define TEXT(target, name, text) \
  { target, name, text, sizeof(text) - 1 }

#define PCD_HEAD                                                                       \
  "VERSION 0.7\nFIELDS x y z rgb n\nSIZE 4 4 4 4 2\nTYPE F F F U I\nCOUNT 1 1 1 1 2\n" \
  "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 1 1 0 0 0\nPOINTS 2\nDATA "

/* The tags of DXF, two lines each, are written a line an entity. */
#define DRAWING                                                                                   \
  "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC\n"                                                \
  "0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 b 10 0 20 0 30 0\n"                                           \
  "0 LWPOLYLINE 8 0 90 3 70 1 10 0 20 0 42 0.5 10 9 20 0 10 9 20 9 0 INSERT 2 c 0 ENDBLK 8 0\n"   \
  "0 BLOCK 8 0 2 c 10 0 20 0 30 0 0 CIRCLE 10 1 20 1 40 2 0 ENDBLK 8 0 0 ENDSEC\n"                \
  "0 SECTION 2 ENTITIES\n"                                                                        \
  "0 POLYLINE 8 A 66 1 70 16 71 2 72 2 0 VERTEX 10 0 20 0 30 0 0 VERTEX 10 1 20 0 30 0\n"         \
  "0 VERTEX 10 0 20 1 30 0 0 VERTEX 10 1 20 1 30 1 0 SEQEND\n"                                    \
  "0 POLYLINE 8 A 66 1 70 64 0 VERTEX 10 0 20 0 30 0 70 192 0 VERTEX 10 1 20 0 30 0 70 192\n"     \
  "0 VERTEX 10 0 20 1 30 0 70 192 0 VERTEX 70 128 71 1 72 2 73 3 0 SEQEND\n"                      \
  "0 POLYLINE 8 A 66 1 70 1 0 VERTEX 10 0 20 0 42 1 0 VERTEX 10 2 20 0 0 VERTEX 10 2 20 2\n"      \
  "0 SEQEND 0 SOLID 8 S 10 0 20 0 11 1 21 0 12 0 22 1 13 1 23 1 210 0 220 1 230 0\n"              \
  "0 3DFACE 8 F 10 0 20 0 30 0 11 1 21 0 31 0 12 1 22 1 32 0 13 0 23 1 33 0\n"                    \
  "0 MESH 8 M 92 3 10 0 20 0 30 0 10 1 20 0 30 0 10 0 20 1 30 0 93 4 90 3 90 0 90 1 90 2 94 0\n"  \
  "0 INSERT 8 I 2 b 10 5 20 5 41 2 42 1 50 30 70 2 71 2 44 3 45 3\n"                              \
  "0 LWPOLYLINE 8 W 90 3 70 1 10 0 20 0 10 4 20 0 10 4 20 4 1001 JALON 1000 face=1 1000 part=w\n" \
  "1000 number=0 1000 class=wall 0 TEXT 8 T 1 word 0 LINE 8 L 10 0 20 0 11 1 21 1 0 ENDSEC\n"     \
  "0 EOF"

#define CITY                                                                                      \
  "{\"type\":\"CityJSON\",\"version\":\"2.0\",\"transform\":{\"scale\":[0.001,0.001,0.001],"      \
  "\"translate\":[0,0,5]},\"metadata\":{\"referenceSystem\":"                                     \
  "\"https://www.opengis.net/def/crs/EPSG/0/2154\"},\"CityObjects\":{\"a\":{\"type\":"            \
  "\"Building\",\"attributes\":{\"part\":0,\"name\":\"x\",\"class\":\"building\",\"groups\":"     \
  "[{\"part\":1,\"part_of\":0}]},\"geometry\":[{\"type\":\"Solid\",\"lod\":\"3\",\"boundaries\":" \
  "[[[[0,2,1]],[[0,1,3]],[[1,2,3]],[[2,0,3]]]],\"semantics\":{\"surfaces\":[{\"type\":"           \
  "\"WallSurface\",\"part\":2,\"part_of\":1,\"children\":[1]},{\"type\":\"Window\",\"part\":3,"   \
  "\"part_of\":2,\"parent\":0,\"sigma_m\":[0.1,2],\"face\":[7,8],\"closes_opening\":true}],"      \
  "\"values\":[[0,1,null,0]]}}]},\"b\":{\"type\":\"BuildingPart\",\"parents\":[\"a\"],"           \
  "\"geometry\":[{\"type\":\"MultiSurface\",\"lod\":1,\"boundaries\":[[[0,1,2],[1,2,3]]]}]}},"    \
  "\"vertices\":[[0,0,0],[9,0,0],[0,9,0],[0,0,9]]}"

#define OBJ                                                                                     \
  "# another program\nmtllib a.mtl\nv 0 0 0 1\nv 9 0 0\nv 0 9 0\nv 1 1 0 0.5 0.5 0.5\nvt 0 0\n" \
  "vn 0 0 1\ng a b\nusemtl m\ns 1\nf 1/1/1 2//1 3/1\no next\nf -4 -3 -2 -1\nl 1 2 \\\n3\np 1\n"

#define NOTED_OBJ                                                                              \
  "# Jalon, coordinates in metres\n#: part 0 class wall name w\n#: part 1 of 0 class window "  \
  "depth 0.2 name x y\nv 0 0 0\nv 9 0 0\nv 0 9 0\nv 1 1 0\nv 1 2 0\nv 2 1 0\no w\ng plane_5\n" \
  "f 1 2 3\no outlines\n#: face part 0 id 5 class 1 sigma 0.1\ng outline_5\nl 1 2 3 1\n"       \
  "#: hole part 1\nl 4 5 6 4\n#: solid part 0 first 0 count 1\n#: mesh\nf 4 5 6\n"

static const struct {
  const char *target, *name, *text;
  size_t bytes;
} kTexts[] = {
    TEXT("pcd", "ascii.pcd", PCD_HEAD "ascii\n1 2 3 255 -1 1\n4 5 6 77 2 3\n"),
    TEXT("pcd", "packed.pcd",
         PCD_HEAD "binary_compressed\n\x06\0\0\0\x28\0\0\0\x01\x02\x03\xE0\x1D\x01"),
    TEXT("ply", "ascii.ply",
         "ply\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty list uchar int a\n"
         "element vertex 2\nproperty double x\nproperty float y\nproperty int z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\n"
         "property list uchar float q\nend_header\n2 5 6\n1 2 3 4 5 6 1 0.5\n7 8 9 1 2 3 0\n"),
    TEXT("ply", "stations.ply",
         "ply\nformat ascii 1.0\ncomment stations {\"jalon_stations\": 1, \"stations\": "
         "[{\"first\": 0, \"count\": 2}]}\nelement vertex 2\nproperty float x\nproperty float y\n"
         "property float z\nend_header\n1 2 3\n4 5 6\n"),
    TEXT("ply", "big.ply",
         "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
         "property float z\nend_header\n\x3F\x80\0\0\x40\0\0\0\x40\x40\0\0"),
    TEXT("ply_model", "ascii.ply",
         "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n"),
    TEXT("pts", "blocks.pts", "2\n1 2 3 -7 1 2 3\n4 5 6 7 8 9 10\n1\n7 8 9 1 2 3 4\n"),
    TEXT("xyz", "header.xyz", "# x y z intensity\n//X,Y,Z,R,G,B\n1,2,3,4,5,6\n7,8,9,1,2,3\n"),
    TEXT("xyz", "bare.xyz", "2\n1;2;3;0.5\n\n 4;5;6;1e-3\n"),
    TEXT("csv", "named.csv", "id,x,y,z,label,nx,ny,nz\n1,2,3,4,5,0,0,1\n2,3,4,5,6,0,1,0\n"),
    TEXT("text_columns", "named",
         "x,y,z,red,green,blue,-,label\n1 2 3 4 5 6 7 8\n2 3 4 5 6 7 8 9\n"),
    TEXT("stations", "ranges",
         "{\"jalon_stations\": 1, \"file\": \"a.xyz\", \"points\": 8, \"stations\": "
         "[{\"name\": \"a\", \"first\": 0, \"count\": 5, \"pose\": "
         "[1, 0, 0, 5, 0, 1, 0, -3, 0, 0, 1, 1.7]}, {\"name\": \"b\", \"first\": 5, \"count\": 3, "
         "\"position\": [1, 2, 3]}]}"),
    TEXT("stations", "open",
         "{\"jalon_stations\": 1, \"points\": 8, \"stations\": [{\"first\": 0, \"count\": 8}]}"),
    TEXT("ptx", "two.ptx",
         "1\n2\n1 2 3\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 2 3 1\n1 2 3 0.5\n"
         "0 0 0 0.5\n1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n4 5 6 "
         "1\n"),
    TEXT("obj", "others.obj", OBJ),
    TEXT("obj", "noted.obj", NOTED_OBJ),
    TEXT("obj_faces", "others.obj", OBJ),
    TEXT("obj_faces", "noted.obj", NOTED_OBJ),
    TEXT("stl", "ascii.stl",
         "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\n"
         "endloop\nendfacet\nendsolid a b\nsolid\nendsolid\n"),
    TEXT("city.json", "others.city.json", CITY),
    TEXT("dxf", "others.dxf", DRAWING),
    TEXT("dxf_faces", "others.dxf", DRAWING),
    TEXT("trajectory_text", "full.csv",
         "# axes ned\n# crs EPSG:2154\ntime;x;y;z;roll_deg;pitch_deg;yaw_deg;vx;vy;vz;sx;sy;sz;svx;"
         "svy;svz;sroll;spitch;syaw\n0;1;2;3;1;2;3;1;0;0;.1;.1;.1;1;1;1;.1;.1;.1\n"
         "1;2;2;3;1;2;3;1;0;0;.1;.1;.1;1;1;1;.1;.1;.1\n"),
    TEXT("m3c2_file", "whole.txt",
         "[General]\r\nM3C2VER=1\r\nNormalScale=0.5\r\nNormalMode=1\r\nNormalMinScale=0.2\r\n"
         "NormalMaxScale=1\r\nNormalStep=0.2\r\nNormalUseCorePoints=false\r\nSearchScale=0.5\r\n"
         "SearchDepth=2\r\nSubsampleRadius=0.07\r\nSubsampleEnabled=true\r\n"
         "NormalPreferedOri=4\r\nRegistrationError=0.004\r\nRegistrationErrorEnabled=true\r\n"
         "UseMedian=true\r\nUseMinPoints4Stat=true\r\nMinPoints4Stat=5\r\n"
         "PositiveSearchOnly=false\r\n"),
    TEXT("law", "gauss", "{\"law\": \"gauss\", \"mean\": 0.001, \"sigma\": 0.005}"),
    TEXT("law", "shifted",
         "{\"law\": \"weibull\", \"shape\": 1.5, \"scale\": 0.005, \"shift\": 0.001}"),
    TEXT("law", "empirical", "{\"law\": \"empirical\", \"quantiles\": [0, 0.1, 0.2]}"),
    TEXT("network", "polygon",
         "from;to;direction;zenith;distance;instrument_height;target_height;setup;"
         "sigma_direction;sigma_distance;code\nA;B;0;100;50;1.5;1.5;1;0.001;0.002;-\n"
         "A;C;50;100;30;1.5;1.5;1;;;350\nB;C;159.57;100;35.76;1.5;1.5;2;;;350\n"
         "B;A;200;100;50;1.5;1.5;2;;;-\nB;A;0;300;50;1.5;1.5;2;;;\n\0"
         "id;x;y;z;sx;sy;sz;code\nA;0;0;0;0;0;0;-\nB;0;50;0;0;0.01;0;1\nC;20;20;0;;;;\n"),
    TEXT("codes", "door",
         "\0"
         "4;0;0.5;0.5;350\n5;0;1.5;2.5;350\n6;0;0;0;777\n"),
    TEXT(
        "codes", "building",
        "\0ID;X;Y;Z;code\n1;0;0;4;300.2\n2;4;0;4;300\n3;4;4;4;300\n4;0;4;4;300+350\n5;0;0;0;300.0\n"
        "6;0;1;2;350\n7;0;2;0;360.2\n8;0;3;0;360.3\n9;0;3;2;360.0\n10;3;0;3;370\n11;3.1;0;3;371\n"),
    TEXT("codes", "target",
         "\x01"
         "1;0;1;1;300\n2;1;0;1;350\n3;2;2;0;360\n4;1;0;2;360\n"),
    TEXT("codes", "table",
         "\0"
         "1;0;1;1;12.2\n2;0;2;1;12.3\n3;0;2;2;12.0\n\0"
         "{\"name\": \"survey\", \"separator\": \"+\", \"modifiers\": {\"start\": 2, \"next\": 4, "
         "\"curve\": 3, \"close\": 0, \"offset\": 8}, \"codes\": [{\"from\": 10, \"to\": 20, "
         "\"name\": \"window\", \"geometry\": \"outline\", \"class\": 2, \"distance_m\": 0.04, "
         "\"hinged\": true}]}"),
    TEXT("notes", "whole",
         "{\"title\": \"a\", \"input\": {\"file\": \"b\", \"points\": 5, \"wet\": true}, "
         "\"scanner\": {\"sigma_range_m\": 0.002}, \"times\": {\"reading\": 0.5}}"),
};

void write_seed_texts(void) {
  for (size_t i = 0; i < sizeof kTexts / sizeof *kTexts; ++i) {
    const int is_drawing = kTexts[i].text[0] == '0' && kTexts[i].text[1] == ' ';
    if (is_drawing) put_lines(kTexts[i].target, kTexts[i].name, kTexts[i].text, kTexts[i].bytes);
    else put(kTexts[i].target, kTexts[i].name, -1, kTexts[i].text, kTexts[i].bytes);
  }
}
