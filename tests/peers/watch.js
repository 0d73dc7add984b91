// npm ar-drone stays on the ground, changes a setting and watches forty pictures.
// Usage: node watch.js ADDRESS
const arDrone = require('ar-drone');
const PaVEParser = require('ar-drone/lib/video/PaVEParser');

const client = arDrone.createClient({ ip: process.argv[2] });
const seen = { config: null, frames: [], keyFrames: 0, errors: [], battery: null };

client.on('error', (error) => seen.errors.push(String(error)));
client.on('batteryChange', (battery) => { seen.battery = battery; });
client.config('control:altitude_max', '2500', (error) => { seen.config = String(error); });

const parser = new PaVEParser();
parser.on('error', (error) => seen.errors.push(String(error)));
parser.on('data', (frame) => {
  const { frame_number, display_width, display_height, header_size } = frame;
  seen.frames.push([frame_number, display_width, display_height, header_size]);
  if (frame.frame_type === 1) seen.keyFrames += 1;
  if (seen.frames.length === 40) {
    console.log(JSON.stringify(seen));
    process.exit(0);
  }
});
client.getVideoStream().on('data', (data) => parser.write(data));
