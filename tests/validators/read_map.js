// Reads a map file with an npm package that shares nothing with GDAL and prints it as GeoJSON: shapefile for .shp,
// also in a .zip (jszip), @tmcw/togeojson for .kml, .kmz and .gpx, @placemarkio/check-geojson for .geojson (where a fault ends with status 1).
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
    if (ending === '.zip' || ending === '.kmz') {
        const zip = await fromModules('jszip').loadAsync(fs.readFileSync(file));
        const names = Object.keys(zip.files);
        if (ending === '.kmz') {
            return kmlOf(await zip.file('doc.kml').async('string'), 'kml');
        }
        const name = names.find((each) => each.endsWith('.shp'));
        const shapes = await zip.file(name).async('nodebuffer');
        const table = await zip.file(name.replace('.shp', '.dbf')).async('nodebuffer');
        const read = await fromModules('shapefile').read(shapes, table, { encoding: 'utf-8' });
        return { ...read, names };
    }
    const text = fs.readFileSync(file, 'utf8');
    if (ending === '.geojson') {
        return fromModules('@placemarkio/check-geojson').check(text);
    }
    return kmlOf(text, ending.slice(1));
}

function kmlOf(text, format) {
    const { DOMParser } = fromModules('@xmldom/xmldom');
    const document = new DOMParser().parseFromString(text, 'text/xml');
    return fromModules('@tmcw/togeojson')[format](document);
}

read().then((collection) => console.log(JSON.stringify(collection))).catch((error) => {
    console.error(String(error));
    process.exitCode = 1;
});
