// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// glTF files by Khronos's validator: node check_glb.js FOLDER_OF_THE_VALIDATOR FILE ...
// Errors, warnings and informations all count.
"use strict";
const fs = require("fs"), path = require("path");
const validator = require(path.join(process.argv[2], "node_modules", "gltf-validator"));
(async () => {
  let passed = 0, failed = 0;
  for (const file of process.argv.slice(3)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {uri: path.basename(file)});
    const {numErrors, numWarnings, numInfos, numHints, messages} = report.issues;
    const issues = numErrors + numWarnings + numInfos + numHints;
    if (issues) failed++; else passed++;
    console.log((issues ? "not ok" : "ok") + " - " + path.basename(path.dirname(file)) + "/" + path.basename(file) + ": " +
      report.info.drawCallCount + " draw calls, " + report.info.totalTriangleCount + " triangles, " + issues + " issues");
    for (const m of messages.slice(0, 5)) console.log("    " + m.code + " " + m.pointer + " " + m.message);
  }
  console.log(passed + " passed, " + failed + " failed");
})();
