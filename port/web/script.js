// contact2d for pages of one's own: port/web/README.md. The program is in it; nothing is fetched.
@include engine.js
const contact2dProgram = `
@include contact2d.b64
`;
// A function that runs a command: (words, files, tell) -> {status, out, err, files}, as runContact2d without its module.
async function contact2d() {
  const module = await loadContact2d(contact2dProgram);
  return (words, files, tell) => runContact2d(module, words, files, tell);
}
