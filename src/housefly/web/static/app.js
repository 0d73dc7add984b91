import"./chunk-chunk-S72SCAVZ.js";
