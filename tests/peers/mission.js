// npm ardrone-autonomy closes its own position loop over navdata.
// Usage: node mission.js ADDRESS
const autonomy = require('ardrone-autonomy');

const mission = autonomy.createMission({ ip: process.argv[2] });
const reached = [];
const note = (name) => mission.taskSync(() => {
  reached.push([name, { ...mission.control().state() }]);
});

mission.takeoff().zero();
note('takeoff');
mission.altitude(1.3);
note('altitude');
mission.forward(1);
note('forward');
mission.land();
mission.run((error) => {
  console.log(JSON.stringify({ error: error ? String(error) : null, reached }));
  process.exit(0);
});
