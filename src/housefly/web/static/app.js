import"./chunk-chunk-R3ZDEBOA.js";
