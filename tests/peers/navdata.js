// npm ar-drone's parser as an oracle: reads packets in hexadecimal, one a line, and prints what it
// understood, one JSON object a line.
const parseNavdata = require('ar-drone/lib/navdata/parseNavdata');

require('readline').createInterface({ input: process.stdin }).on('line', (line) => {
  try {
    console.log(JSON.stringify(parseNavdata(Buffer.from(line, 'hex'))));
  } catch (error) {
    console.log(JSON.stringify({ error: String(error) }));
  }
});
