// read_mujoco.mjs MODULE FILE MESH...: prints what MuJoCo takes of a robot, as JSON, without the world. MODULE: mujoco.js of npm's @mujoco/mujoco.
import fs from 'fs';
import { pathToFileURL } from 'url';
const load = (await import(pathToFileURL(process.argv[2]).href)).default;
const mujoco = await load({ printErr: t => console.error(t), print: t => console.error(t) });
let model;
const files = process.argv.slice(3);
for (const f of files.slice(1)) mujoco.FS.writeFile('/' + f.split('/').pop(), fs.readFileSync(f));
mujoco.FS.writeFile('/robot.xml', fs.readFileSync(files[0]));
try { model = mujoco.MjModel.from_xml_path('/robot.xml'); } catch (e) { console.error('refused:', e?.message ?? e); process.exit(1); }
if (!model) { console.error('refused'); process.exit(1); }
const links = [];
for (let i = 1; i < model.nbody; ++i) {
  const [w, x, y, z] = model.body_iquat.slice(4*i, 4*i+4);
  const R = [[1-2*(y*y+z*z),2*(x*y-w*z),2*(x*z+w*y)],[2*(x*y+w*z),1-2*(x*x+z*z),2*(y*z-w*x)],[2*(x*z-w*y),2*(y*z+w*x),1-2*(x*x+y*y)]];
  const I = model.body_inertia.slice(3*i, 3*i+3);
  const t = (a, b) => R[a][0]*I[0]*R[b][0]+R[a][1]*I[1]*R[b][1]+R[a][2]*I[2]*R[b][2];
  links.push({ name: mujoco.mj_id2name(model, 1, i), mass: model.body_mass[i], center: [...model.body_ipos.slice(3*i, 3*i+3)], inertia: [t(0,0),t(0,1),t(0,2),t(1,1),t(1,2),t(2,2)] });
}
console.log(JSON.stringify({ links }));
