// What is known of a pixel: a bit for each of its samples that is in shadow, and from STATE_FACES on one for each that faces the light.
const uint STATE_FACES = 8u;
const uint STATE_SAMPLES = (1u << STATE_FACES) - 1u;
const uint OWNER_PIXEL_BITS = 28u;
const uint OWNER_PIXELS = (1u << OWNER_PIXEL_BITS) - 1u;
