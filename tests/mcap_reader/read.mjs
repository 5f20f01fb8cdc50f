// node read.mjs FILE.mcap: reads with the official indexed reader, checks every checksum, prints one JSON line
// {messages, topics: {topic: count}, first: {topic: first message}, attachments: {name: bytes}}.
import { open } from "node:fs/promises";
import { McapIndexedReader } from "@mcap/core";
import { decompress } from "fzstd";

const handle = await open(process.argv[2], "r");
const readable = {
  size: async () => BigInt((await handle.stat()).size),
  read: async (offset, length) => {
    const buffer = new Uint8Array(Number(length));
    const { bytesRead } = await handle.read(buffer, 0, Number(length), Number(offset));
    if (bytesRead !== Number(length)) throw new Error(`short read at ${offset}`);
    return buffer;
  },
};
const reader = await McapIndexedReader.Initialize({
  readable,
  decompressHandlers: { zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))) },
});
const topics = {};
const first = {};
let messages = 0;
let last = -1n;
for await (const message of reader.readMessages({ validateCrcs: true })) {
  const topic = reader.channelsById.get(message.channelId).topic;
  const value = JSON.parse(new TextDecoder().decode(message.data));
  if (message.logTime < last) throw new Error("messages out of order");
  last = message.logTime;
  first[topic] ??= value;
  topics[topic] = (topics[topic] ?? 0) + 1;
  messages += 1;
}
const stated = Number(reader.statistics.messageCount);
if (stated !== messages) throw new Error(`statistics say ${stated}, read ${messages}`);
const attachments = {};
for await (const { name, data } of reader.readAttachments()) attachments[name] = data.byteLength;
if (Object.keys(attachments).length !== reader.statistics.attachmentCount) throw new Error(`statistics say ${reader.statistics.attachmentCount} attachments`);
await handle.close();
console.log(JSON.stringify({ messages, topics, first, attachments }));
