#!/bin/sh
# OpenCASCADE 8.0 (npm: replicad-opencascadejs 1.1.0): the STEP file of a cylinder whose two edges are rounded by a fillet uses two of its
# four circles twice in one direction, at the rounding whose torus has a left-handed frame. In a closed shell each edge has a use in either
# direction (ISO 10303-42, manifold_solid_brep); OpenCASCADE 7.6.3 writes the same solid so. The volume that OpenCASCADE reads back is right.
# Guess: whatever the frame of the torus, the two uses of a circle have opposite directions.
# Seen: of the four circles, two are used once in either direction, and two twice in the same one. Readers that go by directions take the
# other part of the torus, or refuse the shell.
# Needs: node and npm. Installs nothing outside a temporary folder; fails if the behaviour or the version changes.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-fund --no-audit --legacy-peer-deps replicad@1.1.0 replicad-opencascadejs@1.1.0 >/dev/null
cat >round.mjs <<'END'
import { readFileSync, writeFileSync } from "fs";
import { makeCylinder, measureVolume, setOC } from "replicad";
import start from "./node_modules/replicad-opencascadejs/dist/replicad_single.js";

const base = "node_modules/replicad-opencascadejs/dist/";
setOC(await start({ wasmBinary: readFileSync(base + "replicad_single.wasm"), print: () => {}, printErr: () => {} }));
const part = makeCylinder(4, 10).fillet(0.7);
const text = await part.blobSTEP().text();
writeFileSync("round.step", text);
const entities = {};
for (const found of text.split("DATA;")[1].replace(/\s+/g, "").matchAll(/(#\d+)=([A-Z_0-9]+)\((.*?)\);/g)) {
  entities[found[1]] = { type: found[2], text: found[3], names: found[3].match(/#\d+/g) ?? [], last: found[3].slice(-2, -1) };
}
// The uses of each edge: the direction of the oriented edge in its bound. The senses of faces and curves do not enter.
const uses = {};
for (const face of Object.values(entities).filter((entity) => entity.type === "ADVANCED_FACE")) {
  for (const bound of face.names.slice(0, -1).map((name) => entities[name])) {
    for (const use of entities[bound.names[0]].names.map((name) => entities[name])) {
      (uses[use.names[0]] ??= []).push((use.last === "T") === (bound.last === "T"));
    }
  }
}
const closed = Object.entries(uses).filter(([edge]) => entities[edge].names[0] === entities[edge].names[1]);
const wrong = closed.filter(([, directions]) => directions.length === 2 && directions[0] === directions[1]);
console.log(`${/processor [\d.]+/.exec(text)[0]}, ${closed.length} circles, used twice in one direction ${wrong.length}`);
END
node round.mjs | tee seen
echo "processor 8.0, 4 circles, used twice in one direction 2" >expected
cmp seen expected
