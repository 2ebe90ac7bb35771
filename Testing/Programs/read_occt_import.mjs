// read_occt_import.mjs MODULE FILE...: prints the volumes in mm^3 of the triangles that occt-import-js makes of STEP and BREP files, as JSON. MODULE:
// dist/occt-import-js.js of npm's occt-import-js.
import fs from 'fs';
import { createRequire } from 'module';
const occt = await createRequire(import.meta.url)(process.argv[2])();
const found = {};
for (const file of process.argv.slice(3)) {
  const read = /brep$/.test(file) ? occt.ReadBrepFile : occt.ReadStepFile;
  const result = read(new Uint8Array(fs.readFileSync(file)), { linearUnit: 'millimeter', linearDeflectionType: 'absolute_value',
    linearDeflection: 0.01, angularDeflection: 0.2 });
  let volume = 0, triangles = 0;
  for (const mesh of result.success ? result.meshes : []) {
    const points = mesh.attributes.position.array, index = mesh.index.array;
    const p = k => points.slice(3 * index[k], 3 * index[k] + 3);
    for (let k = 0; k < index.length; k += 3, ++triangles) {
      const [a, b, c] = [p(k), p(k + 1), p(k + 2)];
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    }
  }
  found[file] = { volume, triangles, solids: result.success ? result.meshes.length : 0 };
}
console.log(JSON.stringify({ files: found }));
