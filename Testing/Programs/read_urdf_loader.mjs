// read_urdf_loader.mjs MODULES FILE: prints what npm's urdf-loader takes of a robot, as JSON. MODULES: a node_modules folder with urdf-loader, three and jsdom.
import fs from 'fs';
import { pathToFileURL } from 'url';
const [modules, file] = process.argv.slice(2);
const { JSDOM } = await import(pathToFileURL(`${modules}/jsdom/lib/api.js`).href);
const { window } = new JSDOM();
Object.assign(globalThis, { window, document: window.document, DOMParser: window.DOMParser, Document: window.Document, Element: window.Element });
const { default: URDFLoader } = await import(pathToFileURL(`${modules}/urdf-loader/src/URDFLoader.js`).href);
const loader = new URDFLoader();
loader.loadMeshCb = (...given) => given.pop()(null, new Error('no meshes'));
console.error = () => {};
const robot = loader.parse(fs.readFileSync(file, 'utf8'));
const links = [];
for (const link of Object.values(robot.links)) {
  const { mass, inertia: i, origin } = link.inertial ?? {};
  if (!mass) continue;
  if (origin.rpy.some(x => x !== 0)) throw new Error(`${link.urdfName}: the inertia is turned`);
  links.push({ name: link.urdfName, mass, center: origin.xyz, inertia: [i.ixx, i.ixy, i.ixz, i.iyy, i.iyz, i.izz] });
}
console.log(JSON.stringify({ links }));
