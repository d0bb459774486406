/* SPDX-License-Identifier: MIT
 *
 * The binary interface, byte by byte, on a 64-bit machine: sizes, places of fields, values of constants. A plugin that
 * was built yesterday relies on all of them. A struct that begins with `size` and the elements of spans may grow at
 * their ends: then their size here changes, and nothing else. */
#ifndef REGISTA_TESTS_CONTRACT_ABI_LAYOUT_H
#define REGISTA_TESTS_CONTRACT_ABI_LAYOUT_H

#include <assert.h>
#include <stddef.h>

#include <regista/abi.h>

#define SIZE(type, bytes) static_assert(sizeof(type) == (bytes), "size of " #type)
#define PLACE(type, field, offset) static_assert(offsetof(type, field) == (offset), #type "." #field)
#define VALUE(constant, number) static_assert((constant) == (number), #constant)

VALUE(REGISTA_ABI_MAJOR, 0u);
VALUE(REGISTA_ABI_MINOR, 2u);

SIZE(regista_error, 512);
PLACE(regista_error, text, 0);

SIZE(regista_span, 16);
PLACE(regista_span, data, 0);
PLACE(regista_span, count, 8);
PLACE(regista_span, stride, 12);

SIZE(regista_room, 24);
PLACE(regista_room, data, 0);
PLACE(regista_room, capacity, 8);
PLACE(regista_room, count, 12);
PLACE(regista_room, stride, 16);
PLACE(regista_room, reserved, 20);

SIZE(regista_matrix, 24);
PLACE(regista_matrix, values, 0);
PLACE(regista_matrix, rows, 8);
PLACE(regista_matrix, columns, 12);
PLACE(regista_matrix, stride, 16);
PLACE(regista_matrix, reserved, 20);

SIZE(regista_matrix_room, 24);
PLACE(regista_matrix_room, values, 0);
PLACE(regista_matrix_room, rows, 8);
PLACE(regista_matrix_room, columns, 12);
PLACE(regista_matrix_room, stride, 16);
PLACE(regista_matrix_room, reserved, 20);

SIZE(regista_landmark, 24);
PLACE(regista_landmark, kind, 0);
PLACE(regista_landmark, reserved, 4);
PLACE(regista_landmark, x, 8);
PLACE(regista_landmark, y, 16);

SIZE(regista_role, 24);
PLACE(regista_role, name, 0);
PLACE(regista_role, list, 8);
PLACE(regista_role, priority, 16);
PLACE(regista_role, robot, 20);

SIZE(regista_kick, 56);
PLACE(regista_kick, name, 0);
PLACE(regista_kick, minimum_distance, 8);
PLACE(regista_kick, maximum_distance, 16);
PLACE(regista_kick, duration, 24);
PLACE(regista_kick, impact, 32);
PLACE(regista_kick, distance_error, 40);
PLACE(regista_kick, direction_error, 48);

SIZE(regista_event_name, 16);
PLACE(regista_event_name, kind, 0);
PLACE(regista_event_name, reserved, 4);
PLACE(regista_event_name, name, 8);

SIZE(regista_environment, 328);
PLACE(regista_environment, size, 0);
PLACE(regista_environment, team_size, 4);
PLACE(regista_environment, own_number, 8);
PLACE(regista_environment, subject, 12);
PLACE(regista_environment, field_length, 16);
PLACE(regista_environment, field_width, 24);
PLACE(regista_environment, border_strip, 32);
PLACE(regista_environment, goal_width, 40);
PLACE(regista_environment, goal_depth, 48);
PLACE(regista_environment, goal_area_length, 56);
PLACE(regista_environment, goal_area_width, 64);
PLACE(regista_environment, penalty_area_length, 72);
PLACE(regista_environment, penalty_area_width, 80);
PLACE(regista_environment, penalty_mark_distance, 88);
PLACE(regista_environment, centre_circle_radius, 96);
PLACE(regista_environment, ball_radius, 104);
PLACE(regista_environment, robot_radius, 112);
PLACE(regista_environment, walk_forward, 120);
PLACE(regista_environment, walk_sideways, 128);
PLACE(regista_environment, walk_backward, 136);
PLACE(regista_environment, turn_rate, 144);
PLACE(regista_environment, decision_period, 152);
PLACE(regista_environment, packet_size, 160);
PLACE(regista_environment, packet_budget, 164);
PLACE(regista_environment, landmarks, 168);
PLACE(regista_environment, roles, 184);
PLACE(regista_environment, goal_post_radius, 200);
PLACE(regista_environment, ball_deceleration, 208);
PLACE(regista_environment, halves, 216);
PLACE(regista_environment, reserved, 220);
PLACE(regista_environment, half_length, 224);
PLACE(regista_environment, set_play_distance, 232);
PLACE(regista_environment, kick_reach, 240);
PLACE(regista_environment, kick_reach_angle, 248);
PLACE(regista_environment, camera_half_angle, 256);
PLACE(regista_environment, camera_ball_range, 264);
PLACE(regista_environment, camera_robot_range, 272);
PLACE(regista_environment, head_yaw, 280);
PLACE(regista_environment, head_speed, 288);
PLACE(regista_environment, kicks, 296);
PLACE(regista_environment, events, 312);

SIZE(regista_game, 48);
PLACE(regista_game, size, 0);
PLACE(regista_game, phase, 4);
PLACE(regista_game, set_play, 8);
PLACE(regista_game, own_kick, 12);
PLACE(regista_game, half, 16);
PLACE(regista_game, own_score, 20);
PLACE(regista_game, opponent_score, 24);
PLACE(regista_game, reserved, 28);
PLACE(regista_game, phase_time, 32);
PLACE(regista_game, time_left, 40);

SIZE(regista_robot, 152);
PLACE(regista_robot, number, 0);
PLACE(regista_robot, flags, 4);
PLACE(regista_robot, pose, 8);
PLACE(regista_robot, velocity, 32);
PLACE(regista_robot, covariance, 56);
PLACE(regista_robot, target, 104);
PLACE(regista_robot, time_until_up, 120);
PLACE(regista_robot, age, 128);
PLACE(regista_robot, role, 136);
PLACE(regista_robot, reserved, 140);
PLACE(regista_robot, role_since, 144);

SIZE(regista_opponent, 80);
PLACE(regista_opponent, label, 0);
PLACE(regista_opponent, flags, 4);
PLACE(regista_opponent, position, 8);
PLACE(regista_opponent, velocity, 24);
PLACE(regista_opponent, covariance, 40);
PLACE(regista_opponent, weight, 64);
PLACE(regista_opponent, age, 72);

SIZE(regista_ball, 128);
PLACE(regista_ball, size, 0);
PLACE(regista_ball, flags, 4);
PLACE(regista_ball, position, 8);
PLACE(regista_ball, velocity, 24);
PLACE(regista_ball, covariance, 40);
PLACE(regista_ball, age, 120);

SIZE(regista_world, 72);
PLACE(regista_world, size, 0);
PLACE(regista_world, reserved, 4);
PLACE(regista_world, game, 8);
PLACE(regista_world, ball, 16);
PLACE(regista_world, robots, 24);
PLACE(regista_world, opponents, 40);
PLACE(regista_world, active, 56);

SIZE(regista_task, 72);
PLACE(regista_task, id, 0);
PLACE(regista_task, priority, 4);
PLACE(regista_task, group, 8);
PLACE(regista_task, robot, 12);
PLACE(regista_task, flags, 16);
PLACE(regista_task, reserved, 20);
PLACE(regista_task, before, 24);
PLACE(regista_task, after, 48);

SIZE(regista_waypoint, 32);
PLACE(regista_waypoint, x, 0);
PLACE(regista_waypoint, y, 8);
PLACE(regista_waypoint, score, 16);
PLACE(regista_waypoint, task, 24);
PLACE(regista_waypoint, robot, 28);

SIZE(regista_edge, 8);
PLACE(regista_edge, from, 0);
PLACE(regista_edge, to, 4);

SIZE(regista_frame, 136);
PLACE(regista_frame, size, 0);
PLACE(regista_frame, own_number, 4);
PLACE(regista_frame, tick, 8);
PLACE(regista_frame, time, 16);
PLACE(regista_frame, knowledge, 24);
PLACE(regista_frame, context, 28);
PLACE(regista_frame, mine, 32);
PLACE(regista_frame, common, 40);
PLACE(regista_frame, tasks, 48);
PLACE(regista_frame, waypoints, 64);
PLACE(regista_frame, edges, 80);
PLACE(regista_frame, previous, 96);
PLACE(regista_frame, time_to_task, 112);

SIZE(regista_motion, 24);
PLACE(regista_motion, x, 0);
PLACE(regista_motion, y, 8);
PLACE(regista_motion, heading, 16);

SIZE(regista_visible_area, 48);
PLACE(regista_visible_area, x, 0);
PLACE(regista_visible_area, y, 8);
PLACE(regista_visible_area, heading, 16);
PLACE(regista_visible_area, half_angle, 24);
PLACE(regista_visible_area, range_ball, 32);
PLACE(regista_visible_area, range_robot, 40);

SIZE(regista_measurement, 80);
PLACE(regista_measurement, kind, 0);
PLACE(regista_measurement, label, 4);
PLACE(regista_measurement, position, 8);
PLACE(regista_measurement, heading, 24);
PLACE(regista_measurement, covariance, 32);

SIZE(regista_track_pose, 48);
PLACE(regista_track_pose, heading, 0);
PLACE(regista_track_pose, turn_rate, 8);
PLACE(regista_track_pose, heading_variance, 16);
PLACE(regista_track_pose, velocity_variance, 24);
PLACE(regista_track_pose, target, 32);

SIZE(regista_track, 136);
PLACE(regista_track, label, 0);
PLACE(regista_track, flags, 4);
PLACE(regista_track, x, 8);
PLACE(regista_track, y, 16);
PLACE(regista_track, vx, 24);
PLACE(regista_track, vy, 32);
PLACE(regista_track, weight, 40);
PLACE(regista_track, age, 48);
PLACE(regista_track, covariance, 56);
PLACE(regista_track, motion, 80);
PLACE(regista_track, pose, 80);

SIZE(regista_predictor, 48);
PLACE(regista_predictor, size, 0);
PLACE(regista_predictor, subjects, 4);
PLACE(regista_predictor, predict, 8);
PLACE(regista_predictor, correct, 16);
PLACE(regista_predictor, absorb, 24);
PLACE(regista_predictor, tracks, 32);
PLACE(regista_predictor, track_at, 40);

SIZE(regista_context, 16);
PLACE(regista_context, size, 0);
PLACE(regista_context, reserved, 4);
PLACE(regista_context, holds, 8);

SIZE(regista_cell, 12);
PLACE(regista_cell, robot, 0);
PLACE(regista_cell, first, 4);
PLACE(regista_cell, count, 8);

SIZE(regista_vertex, 16);
PLACE(regista_vertex, x, 0);
PLACE(regista_vertex, y, 8);

SIZE(regista_placement, 104);
PLACE(regista_placement, size, 0);
PLACE(regista_placement, reserved, 4);
PLACE(regista_placement, points, 8);
PLACE(regista_placement, edges, 32);
PLACE(regista_placement, cells, 56);
PLACE(regista_placement, vertices, 80);

SIZE(regista_positioner, 16);
PLACE(regista_positioner, size, 0);
PLACE(regista_positioner, reserved, 4);
PLACE(regista_positioner, place, 8);

SIZE(regista_utility, 16);
PLACE(regista_utility, size, 0);
PLACE(regista_utility, reserved, 4);
PLACE(regista_utility, score, 8);

SIZE(regista_assigner, 16);
PLACE(regista_assigner, size, 0);
PLACE(regista_assigner, flags, 4);
PLACE(regista_assigner, assign, 8);

SIZE(regista_event, 16);
PLACE(regista_event, kind, 0);
PLACE(regista_event, reserved, 4);
PLACE(regista_event, value, 8);

SIZE(regista_offer, 32);
PLACE(regista_offer, handle, 0);
PLACE(regista_offer, bytes, 8);
PLACE(regista_offer, medium, 12);
PLACE(regista_offer, urgency, 16);
PLACE(regista_offer, expiry, 24);

SIZE(regista_budget, 56);
PLACE(regista_budget, size, 0);
PLACE(regista_budget, packets_left, 4);
PLACE(regista_budget, line, 8);
PLACE(regista_budget, match_time_left, 16);
PLACE(regista_budget, since_own, 24);
PLACE(regista_budget, since_team, 32);
PLACE(regista_budget, bytes_free, 40);
PLACE(regista_budget, reserved, 44);
PLACE(regista_budget, share, 48);

SIZE(regista_send, 24);
PLACE(regista_send, size, 0);
PLACE(regista_send, send, 4);
PLACE(regista_send, reason, 8);
PLACE(regista_send, granted_count, 12);
PLACE(regista_send, granted, 16);

SIZE(regista_sender, 24);
PLACE(regista_sender, size, 0);
PLACE(regista_sender, reason_count, 4);
PLACE(regista_sender, decide, 8);
PLACE(regista_sender, reasons, 16);

SIZE(regista_point, 16);
PLACE(regista_point, x, 0);
PLACE(regista_point, y, 8);

SIZE(regista_body, 104);
PLACE(regista_body, size, 0);
PLACE(regista_body, flags, 4);
PLACE(regista_body, task, 8);
PLACE(regista_body, reserved, 12);
PLACE(regista_body, pose, 16);
PLACE(regista_body, motion, 40);
PLACE(regista_body, head_yaw, 64);
PLACE(regista_body, time_until_up, 72);
PLACE(regista_body, contact, 80);
PLACE(regista_body, robots_near, 88);

SIZE(regista_disc, 24);
PLACE(regista_disc, x, 0);
PLACE(regista_disc, y, 8);
PLACE(regista_disc, radius, 16);

SIZE(regista_action, 304);
PLACE(regista_action, size, 0);
PLACE(regista_action, flags, 4);
PLACE(regista_action, motion, 8);
PLACE(regista_action, walk, 12);
PLACE(regista_action, velocity, 16);
PLACE(regista_action, pose, 40);
PLACE(regista_action, gaze, 64);
PLACE(regista_action, kick, 72);
PLACE(regista_action, avoid_count, 76);
PLACE(regista_action, kick_direction, 80);
PLACE(regista_action, kick_distance, 88);
PLACE(regista_action, target, 96);
PLACE(regista_action, avoid, 112);

SIZE(regista_behaviour, 16);
PLACE(regista_behaviour, size, 0);
PLACE(regista_behaviour, flags, 4);
PLACE(regista_behaviour, act, 8);

SIZE(regista_message, 40);
PLACE(regista_message, sender, 0);
PLACE(regista_message, medium, 4);
PLACE(regista_message, time_sent, 8);
PLACE(regista_message, time_heard, 16);
PLACE(regista_message, bytes, 24);
PLACE(regista_message, count, 32);
PLACE(regista_message, reserved, 36);

SIZE(regista_mailbox, 40);
PLACE(regista_mailbox, size, 0);
PLACE(regista_mailbox, reserved, 4);
PLACE(regista_mailbox, transmitted, 8);
PLACE(regista_mailbox, dropped, 16);
PLACE(regista_mailbox, receive, 24);
PLACE(regista_mailbox, describe, 32);

SIZE(regista_host, 48);
PLACE(regista_host, size, 0);
PLACE(regista_host, reserved, 4);
PLACE(regista_host, context, 8);
PLACE(regista_host, offer, 16);
PLACE(regista_host, withdraw, 24);
PLACE(regista_host, bytes_free, 32);
PLACE(regista_host, extension, 40);

SIZE(regista_parameter, 80);
PLACE(regista_parameter, size, 0);
PLACE(regista_parameter, type, 4);
PLACE(regista_parameter, name, 8);
PLACE(regista_parameter, unit, 16);
PLACE(regista_parameter, doc, 24);
PLACE(regista_parameter, minimum, 32);
PLACE(regista_parameter, maximum, 40);
PLACE(regista_parameter, initial, 48);
PLACE(regista_parameter, initial_text, 56);
PLACE(regista_parameter, choices, 64);
PLACE(regista_parameter, choice_count, 72);
PLACE(regista_parameter, flags, 76);

SIZE(regista_value, 24);
PLACE(regista_value, number, 0);
PLACE(regista_value, text, 8);
PLACE(regista_value, text_size, 16);

SIZE(regista_descriptor, 128);
PLACE(regista_descriptor, size, 0);
PLACE(regista_descriptor, abi_major, 4);
PLACE(regista_descriptor, abi_minor, 8);
PLACE(regista_descriptor, parameter_count, 12);
PLACE(regista_descriptor, id, 16);
PLACE(regista_descriptor, version, 24);
PLACE(regista_descriptor, summary, 32);
PLACE(regista_descriptor, licence, 40);
PLACE(regista_descriptor, build_tag, 48);
PLACE(regista_descriptor, parameters, 56);
PLACE(regista_descriptor, parameter_stride, 64);
PLACE(regista_descriptor, reserved, 68);
PLACE(regista_descriptor, table, 72);
PLACE(regista_descriptor, create, 80);
PLACE(regista_descriptor, reset, 88);
PLACE(regista_descriptor, destroy, 96);
PLACE(regista_descriptor, minimum_major, 104);
PLACE(regista_descriptor, minimum_minor, 108);
PLACE(regista_descriptor, reads, 112);
PLACE(regista_descriptor, reserved_too, 116);
PLACE(regista_descriptor, extension, 120);

VALUE(REGISTA_OK, 0);
VALUE(REGISTA_FAILED, 1);
VALUE(REGISTA_SUBJECT_SELF, 1);
VALUE(REGISTA_SUBJECT_BALL, 2);
VALUE(REGISTA_SUBJECT_OPPONENTS, 4);
VALUE(REGISTA_SUBJECT_TEAMMATES, 8);
VALUE(REGISTA_LANDMARK_GOAL_POST, 1);
VALUE(REGISTA_LANDMARK_CENTRE, 2);
VALUE(REGISTA_LANDMARK_PENALTY_MARK, 3);
VALUE(REGISTA_LANDMARK_CORNER, 4);
VALUE(REGISTA_LANDMARK_T_JUNCTION, 5);
VALUE(REGISTA_PHASE_INITIAL, 0);
VALUE(REGISTA_PHASE_READY, 1);
VALUE(REGISTA_PHASE_SET, 2);
VALUE(REGISTA_PHASE_PLAYING, 3);
VALUE(REGISTA_PHASE_FINISHED, 4);
VALUE(REGISTA_SET_PLAY_NONE, 0);
VALUE(REGISTA_SET_PLAY_KICK_OFF, 1);
VALUE(REGISTA_SET_PLAY_KICK_IN, 2);
VALUE(REGISTA_SET_PLAY_GOAL_KICK, 3);
VALUE(REGISTA_SET_PLAY_CORNER_KICK, 4);
VALUE(REGISTA_SET_PLAY_PUSHING_FREE_KICK, 5);
VALUE(REGISTA_SET_PLAY_PENALTY_KICK, 6);
VALUE(REGISTA_ROBOT_ACTIVE, 1);
VALUE(REGISTA_ROBOT_PENALISED, 2);
VALUE(REGISTA_ROBOT_FALLEN, 4);
VALUE(REGISTA_ROBOT_SELF, 8);
VALUE(REGISTA_ROBOT_KNOWN, 16);
VALUE(REGISTA_ROBOT_HAS_TARGET, 32);
VALUE(REGISTA_BALL_KNOWN, 1);
VALUE(REGISTA_TASK_REQUIRED, 1);
VALUE(REGISTA_TASK_ALONG_EDGES, 2);
VALUE(REGISTA_MINE, 0);
VALUE(REGISTA_COMMON, 1);
VALUE(REGISTA_READS_NOTHING, 0);
VALUE(REGISTA_READS_OPPONENTS_MINE, 1);
VALUE(REGISTA_READS_OPPONENTS_COMMON, 2);
VALUE(REGISTA_READS_COVARIANCES, 4);
VALUE(REGISTA_READS_FACINGS, 8);
VALUE(REGISTA_READS_TIMES, 16);
VALUE(REGISTA_READS_WAYPOINTS, 32);
VALUE(REGISTA_READS_EDGES, 64);
VALUE(REGISTA_READS_PREVIOUS, 128);
VALUE(REGISTA_READS_ALL, 0x7fffffff);
VALUE(REGISTA_MEASURED_POSE, 1);
VALUE(REGISTA_MEASURED_LANDMARK, 2);
VALUE(REGISTA_MEASURED_BALL, 3);
VALUE(REGISTA_MEASURED_ROBOT, 4);
VALUE(REGISTA_TRACK_HAS_TARGET, 1);
VALUE(REGISTA_TRACK_VELOCITY, 2);
VALUE(REGISTA_NO_TASK, -1);
VALUE(REGISTA_UNKNOWN_TASK, -2);
VALUE(REGISTA_ASSIGNER_NEGOTIATES, 1);
VALUE(REGISTA_EVENT_PERIOD, 0);
VALUE(REGISTA_EVENT_WHISTLE, 1);
VALUE(REGISTA_EVENT_BALL_FOUND, 2);
VALUE(REGISTA_EVENT_GOALKEEPER_SAW_BALL, 3);
VALUE(REGISTA_EVENT_BALL_KNOWN_AGAIN, 4);
VALUE(REGISTA_EVENT_ROLE_CHANGED, 5);
VALUE(REGISTA_EVENT_BALL_MOVED, 6);
VALUE(REGISTA_EVENT_POSE_MOVED, 7);
VALUE(REGISTA_EVENT_FELL, 8);
VALUE(REGISTA_EVENT_GOT_UP, 9);
VALUE(REGISTA_EVENT_PHASE_CHANGED, 10);
VALUE(REGISTA_EVENT_CONTEXT_CHANGED, 11);
VALUE(REGISTA_EVENT_RETURNED, 12);
VALUE(REGISTA_EVENT_OFFER, 13);
VALUE(REGISTA_EVENT_COUNT, 14);
VALUE(REGISTA_REASON_OWN, 1000);
VALUE(REGISTA_MEDIUM_RADIO, 0);
VALUE(REGISTA_BEHAVIOUR_PLAYS_BALL, 1);
VALUE(REGISTA_BEHAVIOUR_KEEPS_GOAL, 2);
VALUE(REGISTA_BEHAVIOUR_SEARCHES, 4);
VALUE(REGISTA_BODY_SEES_BALL, 1);
VALUE(REGISTA_BODY_BALL_REFUTED, 2);
VALUE(REGISTA_BODY_FALLEN, 4);
VALUE(REGISTA_BODY_PENALISED, 8);
VALUE(REGISTA_BODY_KICKING, 16);
VALUE(REGISTA_BODY_TOUCHED, 32);
VALUE(REGISTA_MOTION_STAND, 0);
VALUE(REGISTA_MOTION_VELOCITY, 1);
VALUE(REGISTA_MOTION_WALK_TO, 2);
VALUE(REGISTA_WALK_BRISK, 1);
VALUE(REGISTA_WALK_STRAIGHT, 2);
VALUE(REGISTA_WALK_CREEP, 4);
VALUE(REGISTA_NO_KICK, -1);
VALUE(REGISTA_MOST_AVOIDED, 8);
VALUE(REGISTA_ACTION_TARGET, 1);
VALUE(REGISTA_KIND_PREDICTOR, 1);
VALUE(REGISTA_KIND_CONTEXT, 2);
VALUE(REGISTA_KIND_POSITIONER, 3);
VALUE(REGISTA_KIND_UTILITY, 4);
VALUE(REGISTA_KIND_ASSIGNER, 5);
VALUE(REGISTA_KIND_SENDER, 6);
VALUE(REGISTA_KIND_MAILBOX, 7);
VALUE(REGISTA_KIND_BEHAVIOUR, 8);
VALUE(REGISTA_KIND_END, 9);
VALUE(REGISTA_TYPE_REAL, 1);
VALUE(REGISTA_TYPE_INTEGER, 2);
VALUE(REGISTA_TYPE_BOOLEAN, 3);
VALUE(REGISTA_TYPE_CHOICE, 4);
VALUE(REGISTA_TYPE_TEXT, 5);
VALUE(REGISTA_TYPE_FILE, 6);
VALUE(REGISTA_PARAMETER_TUNABLE, 1);
VALUE(REGISTA_PARAMETER_LOG_SCALE, 2);

#endif
