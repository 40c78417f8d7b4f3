/**
 * What a merge patch (RFC 7396) makes of a value. What does not change is shared with the old
 * value, which stays as it is.
 */
export function merged(target, patch) {
  if (patch === null || typeof patch !== 'object' || Array.isArray(patch)) {
    return patch;
  }
  const base =
    target !== null && typeof target === 'object' && !Array.isArray(target) ? target : {};
  const result = { ...base };
  for (const [key, value] of Object.entries(patch)) {
    if (value === null) {
      delete result[key];
    } else {
      result[key] = merged(base[key], value);
    }
  }
  return result;
}
