import"./chunk-chunk-AZZP6CBB.js";
