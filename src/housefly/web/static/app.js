import"./chunk-chunk-5TUTTVL3.js";
