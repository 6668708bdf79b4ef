// Lists the messages of an MCAP file through its index with the npm package @mcap/core, as JSON.
'use strict';
const fs = require('fs');
const path = require('path');

const fromModules = require('module').createRequire(path.join(process.env.FURROW_NODE_MODULES, 'any.js'));
const { McapIndexedReader } = fromModules('@mcap/core');

async function main() {
    const bytes = fs.readFileSync(process.argv[2]);
    const reader = await McapIndexedReader.Initialize({ readable: {
        size: async () => BigInt(bytes.length),
        read: async (offset, size) => new Uint8Array(bytes.buffer, bytes.byteOffset + Number(offset), Number(size)),
    } });
    const messages = [];
    for await (const message of reader.readMessages()) {
        const channel = reader.channelsById.get(message.channelId);
        const schema = reader.schemasById.get(channel.schemaId);
        messages.push({ topic: channel.topic, schema: schema.name, encoding: channel.messageEncoding, bytes: message.data.length });
    }
    console.log(JSON.stringify({ profile: reader.header.profile, messages }));
}

main().catch((error) => {
    console.error(String(error));
    process.exitCode = 1;
});
