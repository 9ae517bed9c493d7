// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the search in the site's pages finds what is in them.
//
// usage: node search_test.js SITE

"use strict";
const fs = require("fs");
const vm = require("vm");

const site = process.argv[2];
for (const file of ["full_text.js", "text_index.js"])
  vm.runInThisContext(fs.readFileSync(`${site}/${file}`, "utf8"));

// expect(QUERY, ADDRESS): the page is the first to be found.
function expect(query, address) {
  const [first] = findParts(query, TEXT_INDEX);
  if (first && first.address.startsWith(address)) return;
  console.error(`'${query}' finds ${first ? first.address : "nothing"}, not ${address}`);
  process.exitCode = 1;
}

expect("Strays", "doc_tutorials_9_bad_data.html#");
expect("KNOT", "doc_gallery.html#");
expect("three pieces bridges", "doc_gallery.html#");
expect("--certified-angle slivers", "doc_options.html#");
expect("60 seconds", "index.html#");
for (const query of ["", " ", "zyxw knot"])
  if (findParts(query, TEXT_INDEX).length > 0) {
    console.error(`'${query}' finds something`);
    process.exitCode = 1;
  }
for (const [address] of TEXT_INDEX) {
  const [file, anchor] = address.split("#");
  if (!fs.readFileSync(`${site}/${file}`, "utf8").includes(`id="${anchor}"`)) {
    console.error(`no ${address}`);
    process.exitCode = 1;
  }
}
