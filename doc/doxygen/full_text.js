// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: search in the text of the site's pages, without a server.
"use strict";

// Parts of pages that hold all words of a query, best first: a word in a heading counts
// more than any number in the text. Parts are [address, heading, text].
function findParts(query, parts) {
  const words = query.toLowerCase().split(/\s+/).filter((word) => word !== "");
  const found = [];
  for (const [address, heading, text] of words.length > 0 ? parts : []) {
    const inHeading = heading.toLowerCase();
    const inText = text.toLowerCase();
    if (!words.every((word) => inHeading.includes(word) || inText.includes(word))) continue;
    let rank = 0;
    for (const word of words)
      rank += inHeading.includes(word) ? 100 : Math.min(inText.split(word).length, 50);
    const at = Math.max(0, inText.indexOf(words[0]) - 60);
    found.push({address, heading, rank, excerpt: text.slice(at, at + 200)});
  }
  return found.sort((a, b) => b.rank - a.rank).slice(0, 30);
}

function showParts(query) {
  const list = document.getElementById("found");
  list.replaceChildren();
  for (const part of findParts(query, TEXT_INDEX)) {
    const link = document.createElement("a");
    link.href = part.address;
    link.textContent = part.heading;
    const excerpt = document.createElement("p");
    excerpt.textContent = part.excerpt;
    const item = document.createElement("li");
    item.append(link, excerpt);
    list.append(item);
  }
}
