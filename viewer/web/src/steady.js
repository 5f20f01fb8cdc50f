// Numbers that keep their unit while one looks, and how near they are to a limit.

const PREFIXES = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"], [1e-12, "p"]];

/// The unit of a number that is at most about `full`: 3.3, "N" -> newtons with two decimals; 0.1, "N m" -> mN m with one.
/// returns   {scale, unit, decimals}
export function steadyUnit(full, unit) {
  const known = Number.isFinite(full) && full > 0 ? full : 2; // of SI units
  const [scale, prefix] = PREFIXES.find(([at]) => known >= 2 * at) ?? PREFIXES[PREFIXES.length - 1];
  return { scale, unit: prefix + unit, decimals: Math.max(1, 2 - Math.floor(Math.log10(known / scale))) };
}

/// A number in that unit, of three digits that count at the most, so that its tile keeps its width; what is not known is a dash.
export function sayIn(value, { scale, decimals }) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const shown = value / scale, size = Math.abs(shown);
  return shown.toFixed(Math.min(decimals, size < 9.995 ? 2 : size < 99.95 ? 1 : 0));
}

/// What fills each tile: [N, N m, m, m]; what no limit is known of gets a length of the scene.
/// limits   of `state`; parameters   of `parameters`; workspace, tolerance   of `scene`
export function fullScales(limits, parameters, { workspace, tolerance }) {
  const value = (name) => parameters.find((one) => one.name === name)?.value;
  const force = limits?.force > 0 ? limits.force : 3.3, torque = limits?.torque > 0 ? limits.torque : 0.1;
  const felt = force / (workspace?.force_scale > 0 ? workspace.force_scale : 1); // on the object
  const spring = value("coupling_stiffness"), contact = value("contact_stiffness");
  return { force, torque, stretch: spring > 0 ? felt / spring : 10 * tolerance,
    penetration: contact > 0 ? Math.max(felt / contact, tolerance) : tolerance };
}

/// Share of a limit, 0 to 1; 0 where either is not known.
export const shareOf = (value, full) => (Number.isFinite(value) && full > 0 ? Math.min(1, Math.abs(value) / full) : 0);
