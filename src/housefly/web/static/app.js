import"./chunk-chunk-3JDQFTOK.js";
