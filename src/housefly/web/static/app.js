import"./chunk-chunk-ALJOPHPR.js";
