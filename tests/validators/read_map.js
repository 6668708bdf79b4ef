// Reads a map file with an npm package that shares nothing with GDAL and prints it as GeoJSON: shapefile for .shp,
// @tmcw/togeojson for .kml and .gpx, @placemarkio/check-geojson for .geojson (where a fault ends with status 1).
'use strict';
const fs = require('fs');
const path = require('path');

const modules = process.env.FURROW_NODE_MODULES;
const file = process.argv[2];
if (!modules || !file) {
    console.error('usage: FURROW_NODE_MODULES=... node read_map.js FILE');
    process.exit(2);
}
const fromModules = require('module').createRequire(path.join(modules, 'any.js'));

async function read() {
    const ending = path.extname(file).toLowerCase();
    if (ending === '.shp') {
        return fromModules('shapefile').read(file, undefined, { encoding: 'utf-8' });
    }
    const text = fs.readFileSync(file, 'utf8');
    if (ending === '.geojson') {
        return fromModules('@placemarkio/check-geojson').check(text);
    }
    const { DOMParser } = fromModules('@xmldom/xmldom');
    const document = new DOMParser().parseFromString(text, 'text/xml');
    return fromModules('@tmcw/togeojson')[ending.slice(1)](document);
}

read().then((collection) => console.log(JSON.stringify(collection))).catch((error) => {
    console.error(String(error));
    process.exitCode = 1;
});
