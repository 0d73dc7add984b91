// npm ar-drone flies up, forward, around and down, and prints what it saw as one line of JSON.
// Usage: node fly.js ADDRESS
const arDrone = require('ar-drone');

const client = arDrone.createClient({ ip: process.argv[2] });
const seen = { events: [], altitude: 0, errors: [] };

for (const name of ['takeoff', 'hovering', 'flying', 'landing', 'landed']) {
  client.on(name, () => seen.events.push(name));
}
client.on('error', (error) => seen.errors.push(String(error)));
client.on('navdata', (navdata) => {
  if (navdata.demo) seen.altitude = Math.max(seen.altitude, navdata.demo.altitudeMeters);
});

client.takeoff(() => {
  client.front(0.2);
  setTimeout(() => { client.stop(); client.clockwise(0.5); }, 1000);
  setTimeout(() => client.stop(), 2000);
  setTimeout(() => client.land(() => {
    console.log(JSON.stringify(seen));
    process.exit(0);
  }), 2500);
});
