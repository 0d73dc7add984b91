import"./chunk-chunk-REMONM44.js";
