// Colour scales that people with any colour vision read in the same order: cividis (Nuñez, Anderton and
// Renslow 2018) for sizes, vik (Crameri 2018) for what has a sign, the bright two thirds of plasma (Smith and van der
// Walt 2015) for the speed of particles, which are small and lie on the black of an image.

const CIVIDIS = ["#00224e", "#123570", "#3b496c", "#575d6d", "#707173", "#8a8678", "#a59c74", "#c3b369", "#e1cc55", "#fee838"];
const PLASMA = ["#9c179e", "#bd3786", "#d8576b", "#ed7953", "#fb9f3a", "#fdca26", "#f0f921"];
const VIK = ["#001261", "#033e7d", "#1e6f9d", "#71a8c4", "#c9dde7", "#eacebd", "#d39774", "#be6533", "#8b2706", "#590007"];

const channels = (hex) => [1, 3, 5].map((start) => parseInt(hex.slice(start, start + 2), 16));

/** 256 colours between the stops, 3 bytes each. */
function table(stops) {
  const colours = new Uint8Array(256 * 3);
  const ends = stops.map(channels);
  for (let n = 0; n < 256; n += 1) {
    const place = (n / 255) * (ends.length - 1);
    const low = Math.min(ends.length - 2, Math.floor(place));
    for (let c = 0; c < 3; c += 1) {
      colours[3 * n + c] = Math.round(ends[low][c] + (place - low) * (ends[low + 1][c] - ends[low][c]));
    }
  }
  return colours;
}

const SIZES = table(CIVIDIS);
const SIGNS = table(VIK);
/** Every colour has at least three times the luminance of black, as WCAG 2.1 reckons contrast. */
export const ON_BLACK = table(PLASMA);

/** A scale from `low` to `high`; signed ones should be symmetric about zero. */
export class ColourScale {
  constructor(low, high, signed = false, colours = signed ? SIGNS : SIZES) {
    this.low = low;
    this.high = high > low ? high : low + 1e-9;
    this.signed = signed;
    this.colours = colours;
  }

  /** Red, green and blue of a value, 0 to 255. */
  rgb(value) {
    const share = Math.min(1, Math.max(0, (value - this.low) / (this.high - this.low)));
    const n = 3 * Math.round(255 * share);
    return [this.colours[n], this.colours[n + 1], this.colours[n + 2]];
  }

  /** Paints the scale from left to right. */
  paint(canvas) {
    canvas.width = 256;
    canvas.height = 1;
    const context = canvas.getContext("2d");
    const image = context.createImageData(256, 1);
    for (let n = 0; n < 256; n += 1) {
      image.data.set([this.colours[3 * n], this.colours[3 * n + 1], this.colours[3 * n + 2], 255], 4 * n);
    }
    context.putImageData(image, 0, 0);
  }
}
