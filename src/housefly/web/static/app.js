import"./chunk-chunk-YAZ4PERO.js";
