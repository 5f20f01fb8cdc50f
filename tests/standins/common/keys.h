// Every number of a stand-in that can be set or read, with its value at the start. README.md says
// what each is.
#pragma once

namespace standin {

// clang-format off
#define STANDIN_KEYS(X) \
  /* the device that is pretended */ \
  X(count, 1) X(type, 104) X(model, 0) X(serial, 1001) X(buttons, 0) X(gripper_gap, 0) \
  X(up_axis, 2) \
  X(sdk_major, 3) X(sdk_minor, 17) X(sdk_release, 5) X(sdk_revision, 0) X(status_count, 17) \
  X(max_force, 0) X(max_continuous, 0) X(max_torque, 0) X(torque_unit, 0.001) \
  /* time */ \
  X(rate, 1000) X(jitter_us, 0) X(blocking, 1) X(loop_us, 250) X(timeguard_us, 250) \
  X(init_ms, 50) \
  X(process, 0) X(linger_s, 5) X(comm_timeout_ms, 0) \
  /* safety of the device */ \
  X(watchdog, 255) X(velocity_threshold, 1.5) X(velocity_limit, 1.0) X(impulse_limit, 1.0) \
  X(ramp_rate, 20) X(heating, 0) X(motor_temperature, 0) X(gravity, 1) \
  /* faults, 0: none; fail_*: the vendor's number of the error */ \
  X(unplug, 0) X(cut, 0) X(silent, 0) X(hang, 0) X(nan_pose, 0) X(nan_velocity, 0) \
  X(jump_x, 0) X(jump_y, 0) X(jump_z, 0) X(jump_rx, 0) X(jump_ry, 0) X(jump_rz, 0) \
  X(fail_open, 0) X(fail_init, 0) X(fail_read, 0) X(fail_set, 0) X(fail_stop, 0) \
  X(fail_scheduler, 0) \
  X(saturate, 0) X(names, 7) X(strict_frames, 1) X(scheduler_slots, 64) \
  /* calibration */ \
  X(initialized, 1) X(calibration, 0x5000) X(calibration_style, 4) X(inkwell, 0) \
  X(safety_switch, 1) \
  X(uncalibrated_offset, 0.02) X(skew, 2e-4) \
  /* the hand that holds the handle; SI, axes of the vendor */ \
  X(mass, 0.2) X(spring, 200) X(damping, 9) X(brake_damping, 40) X(weight, 0) X(hold, 0) \
  X(inertia, 2e-4) X(rot_spring, 0.2) X(rot_damping, 0.01) \
  X(target_x, 0) X(target_y, 0) X(target_z, 0) X(target_rx, 0) X(target_ry, 0) X(target_rz, 0) \
  X(push_x, 0) X(push_y, 0) X(push_z, 0) X(sweep_amplitude, 0) X(sweep_hz, 1) X(sweep_axis, 0) \
  /* state of the handle */ \
  X(px, 0) X(py, 0) X(pz, 0) X(vx, 0) X(vy, 0) X(vz, 0) X(qw, 1) X(qx, 0) X(qy, 0) X(qz, 0) \
  X(wx, 0) X(wy, 0) X(wz, 0) X(step_time, 0) X(start_time, 0) \
  /* state of the device: mode 0 idle, 1 force, 2 brake */ \
  X(mode, 0) X(opened, 0) X(plugged, 1) X(regulated, 0) X(expert, 0) X(force_off_cause, 0) \
  X(limit_force, -1) X(limit_torque, -1) \
  X(force_output, 0) X(clamping, 0) X(ramping, 1) X(force_check, 1) X(velocity_check, 1) \
  X(impulse_check, 1) X(one_frame, 1) X(status_light, 0) \
  /* what was sent: the numbers as they came */ \
  X(last_fx, 0) X(last_fy, 0) X(last_fz, 0) X(last_tx, 0) X(last_ty, 0) X(last_tz, 0) \
  X(last_fg, 0) \
  X(applied_fx, 0) X(applied_fy, 0) X(applied_fz, 0) X(applied_tx, 0) X(applied_ty, 0) \
  X(applied_tz, 0) \
  X(last_set_time, 0) X(force_off_time, 0) X(torque_pname, 0) \
  /* counters */ \
  X(reads, 0) X(sets, 0) X(errors, 0) X(frames, 0) X(ticks, 0) X(late_ticks, 0) X(callbacks, 0) \
  X(outside_frame, 0) X(after_close, 0) X(non_finite, 0) X(set_while_off, 0) \
  X(set_while_regulated, 0) \
  X(off_scheduler, 0) X(torque_sets, 0) X(torque_ignored, 0) X(torque_nonzero, 0) \
  X(watchdog_trips, 0) \
  X(velocity_trips, 0) X(saturations, 0) X(timeguards, 0) X(force_max, 0) X(torque_max, 0) \
  X(expert_calls, 0) X(sdk_calls, 0) \
  /* services: where they listen, how they answer */ \
  X(port, 0) X(events_port, 0) X(form, 0) X(protocol, 1) X(delay_ms, 0) X(repeat_ms, -1) \
  X(dead_zone, 2) X(counts_max, 350) X(udp, 1) X(velocity_reports, 1) X(force_reports, 1) \
  X(drop_resets, 1) X(calibrated, 1) X(ready, 1) X(powered, 1) X(started, 1) X(in_use_by_other, 0) \
  X(verse_grip, 2) X(grip_ready, 1) X(grip_battery, 0.8) X(no_version, 0) X(pad_type, 0) \
  X(no_permission, 0) X(not_a_pad, 0) X(rumble, 1) \
  /* faults of what is sent: the kind, until 0 */ \
  X(garbage, 0) X(half, 0) X(drop, 0) X(refuse, 0) X(die, 0) X(wrong_cookie, 0) X(lie_length, 0) \
  X(null_pose, 0) X(overrun, 0) \
  /* axes of mice and pads, as the device tells them */ \
  X(axis_x, 0) X(axis_y, 0) X(axis_z, 0) X(axis_rx, 0) X(axis_ry, 0) X(axis_rz, 0) \
  X(hat_x, 0) X(hat_y, 0) \
  /* what services were sent */ \
  X(clients, 0) X(connections, 0) X(messages, 0) X(answers, 0) X(bad_messages, 0) X(wrong_form, 0) \
  X(probes, 0) X(configures, 0) X(positions, 0) X(keepalives, 0) X(fields, 0) X(field_active, 0) \
  X(field_fx, 0) X(field_fy, 0) X(field_fz, 0) X(field_ox, 0) X(field_oy, 0) X(field_oz, 0) \
  X(field_jxx, 0) X(field_jxy, 0) X(field_jxz, 0) X(field_jyx, 0) X(field_jyy, 0) \
  X(field_jyz, 0) X(field_jzx, 0) X(field_jzy, 0) X(field_jzz, 0) X(field_radius, 0) \
  X(outside_field, 0) X(reports, 0) X(udp_reports, 0) \
  X(udp_messages, 0) X(lobs, 0) X(sensitivity, 1) X(grabbed, 0) \
  X(clock_id, 0) X(effects, 0) X(effect_uploads, 0) X(effect_erases, 0) X(effect_plays, 0) \
  X(rumble_strong, 0) X(rumble_weak, 0) X(rumble_ms, 0) X(rumble_on, 0) X(rumble_off_time, 0)
// clang-format on

enum Key : int {
#define STANDIN_KEY(name, value) k_##name,
  STANDIN_KEYS(STANDIN_KEY)
#undef STANDIN_KEY
      kKeyCount
};

}  // namespace standin
