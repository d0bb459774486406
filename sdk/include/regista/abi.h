/* SPDX-License-Identifier: MIT
 *
 * The boundary between a Regista host and its strategy plugins. This file is the specification: nothing else is
 * shared, and what is not promised here may change. It is plain C11 and compiles as C++20; comfortable C++ for plugin
 * authors is in <regista/plugin.hpp> and the header of each kind.
 *
 * WHAT A PLUGIN IS
 *   A shared object that exports exactly one symbol, regista_plugin_entry(). A descriptor behind it names a plugin,
 *   declares its parameters, and hands out one table of calls for each kind it implements. One instance may serve
 *   several kinds. The host creates one instance per robot and per use; instances share nothing.
 *
 * LIFE OF AN INSTANCE
 *   create -> reset -> any calls of its kinds -> destroy. reset may come again at any time (a new match). A shared
 *   object is never unloaded. The calls of one instance never overlap, and it makes none of the host's but from within
 *   them. Two instances may be called by two threads at the same time.
 *
 * ONE DECISION OF A ROBOT calls, in this order
 *   dropped                    of offers whose time has come; before decide, of those replaced or withdrawn since
 *   predict, correct, tracks   of the own models; then predict of those of teammates
 *   absorb, receive            for each packet that arrived: its models, whose tracks are read too, then its segments
 *   tracks                     of the models of teammates
 *   holds                      every context, by priority
 *   place, score, assign       of the context in force; no context holds: none of them
 *   act                        of the behaviour of the own role, or of that for robots without one
 *   decide                     in Ready, Set and Playing, when a context holds and the robot is not penalised
 *   transmitted                of the offers that left; then absorb of the own packet, as the others will decode it
 *   All else happens in every phase, also while the robot is penalised or lies on the ground.
 *
 * RULES FOR EVERY CALL
 *   - Chance comes from the seed of reset() alone; time comes from the frame alone. No clock, thread, file, global
 *     variable that changes, or change of the floating-point environment. The same calls must give the same bytes.
 *   - A pointer that goes in is valid, read-only and owned by the host until the call returns. Null appears only where
 *     it is said. Room for an answer is owned by the host too; the plugin writes at most `capacity` elements.
 *   - Nothing is thrown across. A call returns REGISTA_OK, or REGISTA_FAILED after writing one line to `error`.
 *   - The host checks all it takes back (finite, in range, as promised below). A violation ends the match with an
 *     error that names plugin, robot, tick and value.
 *   - Strings are UTF-8, end with NUL, and live as long as the shared object (plugin) or the instance (host).
 *   - Reserved fields and flags that are not named here: write 0, and ignore what stands there. A phase or set play
 *     that a plugin does not know it takes as the first of its list; elements of arrays whose kind it does not know it
 *     leaves out. What it answers is named here.
 *
 * UNITS AND FRAMES
 *   SI and radians. The field frame is the own team's: origin at the centre, x towards the opponent's goal, y to the
 *   left. The robot frame: x ahead, y to the left. Headings are in (-pi, pi]. Time is seconds since the start of the
 *   match; it stands still between the halves. Covariances are symmetric and positive semi-definite; of each pair of
 *   equal entries one is told: of a place xx, xy, yy; of a pose these and x heading, y heading, heading heading; of a
 *   motion those of its place and x vx, x vy, y vx, y vy, vx vx, vx vy, vy vy.
 *
 * GROWTH
 *   While the major version is 0, a plugin must have been built against the host's minor version. From 1.0 on majors
 *   must be equal and a plugin's `minimum` is at most the host's version. Structs that start with `size` grow at
 *   their ends: a reader uses no field beyond the size it is given. Elements of arrays grow too and come with their
 *   stride: step by it, never by sizeof. Arrays of plain numbers do not grow. Where a plugin writes elements that are
 *   larger than it knows, the host has set the rest to 0. Constants keep their values for ever. docs/abi.md says what
 *   may change when.
 */
/* clang-format off */
#ifndef REGISTA_ABI_H
#define REGISTA_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define REGISTA_ABI_MAJOR 0u
#define REGISTA_ABI_MINOR 2u
#define REGISTA_ENTRY_NAME "regista_plugin_entry"

/* Result of a call. */
enum { REGISTA_OK = 0, REGISTA_FAILED = 1 };

/* Where a failed call says why: one line, NUL-terminated. The host clears it before each call. */
typedef struct regista_error {
  char text[512];
} regista_error;

/* `count` elements, each `stride` bytes after the one before. `data` may be null when `count` is 0. */
typedef struct regista_span {
  const void* data;
  uint32_t count;
  uint32_t stride;
} regista_span;

/* Room for elements that a plugin writes: element i begins at data + i * stride, i < capacity. count comes in as 0. The
 * plugin writes every field that it knows: what stands in one before is anything. */
typedef struct regista_room {
  void* data;
  uint32_t capacity, count;
  uint32_t stride;
  uint32_t reserved;
} regista_room;

/* Row-major; element (i, j) is values[i * stride + j]. */
typedef struct regista_matrix {
  const double* values;
  uint32_t rows, columns;
  uint32_t stride;                   /* in elements, >= columns */
  uint32_t reserved;
} regista_matrix;

/* The same as room for an answer. */
typedef struct regista_matrix_room {
  double* values;
  uint32_t rows, columns;
  uint32_t stride;                   /* in elements, >= columns */
  uint32_t reserved;
} regista_matrix_room;

/* --- Environment: given once, at create ---------------------------------------------------------------------- */

/* What a predictor instance models. A bit each, so that a predictor can declare several. */
enum {
  REGISTA_SUBJECT_SELF = 1,      /* the own pose: exactly one track, whose label is the own number */
  REGISTA_SUBJECT_BALL = 2,      /* hypotheses of the one ball, the best first; none when it is lost */
  REGISTA_SUBJECT_OPPONENTS = 4, /* anonymous robots; labels are stable while a track lives */
  REGISTA_SUBJECT_TEAMMATES = 8  /* the robots of the own team that were heard of; label = shirt number */
};

/* Kinds of landmark. A sighting tells the kind, not which one of that kind it is. */
enum {
  REGISTA_LANDMARK_GOAL_POST = 1,
  REGISTA_LANDMARK_CENTRE = 2,       /* centre of the centre circle */
  REGISTA_LANDMARK_PENALTY_MARK = 3,
  REGISTA_LANDMARK_CORNER = 4,       /* where touch line and goal line meet */
  REGISTA_LANDMARK_T_JUNCTION = 5    /* where the halfway line meets a touch line, or an area line meets a goal line */
};

typedef struct regista_landmark {
  int32_t kind;
  int32_t reserved;
  double x, y;                       /* field frame */
} regista_landmark;

/* One row of the team's table of roles. Its index in the table is the id of the role and of its task. */
typedef struct regista_role {
  const char* name;                  /* as in the team's YAML, unique in the table */
  const char* list;                  /* the role list it stands in, e.g. "playing" */
  int32_t priority;                  /* place in its list; 0 is the most important */
  int32_t robot;                     /* shirt number that alone may take it while that robot is active, 0 = any */
} regista_role;

/* One kind of kick that the robot can do. The ball leaves `impact` s after the beginning; the robot stands until
 * `duration` is over. */
typedef struct regista_kick {
  const char* name;                  /* as in the robot's profile */
  double minimum_distance, maximum_distance; /* that the ball rolls, m */
  double duration, impact;           /* s */
  double distance_error;             /* half width of a triangular law, relative */
  double direction_error;            /* standard deviation, rad */
} regista_kick;

/* What an event is called in accounts of packets and in recordings. */
typedef struct regista_event_name {
  int32_t kind;                      /* REGISTA_EVENT_*, or one that this header does not know */
  int32_t reserved;
  const char* name;                  /* lower_snake_case */
} regista_event_name;

typedef struct regista_environment {
  uint32_t size;
  uint32_t team_size;                /* robots are numbered 1..team_size */
  int32_t own_number;                /* the robot that this instance works for */
  uint32_t subject;                  /* REGISTA_SUBJECT_*, for a predictor; else 0 */
  double field_length, field_width;  /* between the centres of the lines */
  double border_strip;               /* green beyond the lines */
  double goal_width, goal_depth;     /* inner width */
  double goal_area_length, goal_area_width;
  double penalty_area_length, penalty_area_width;
  double penalty_mark_distance;      /* from the goal line */
  double centre_circle_radius;
  double ball_radius;
  double robot_radius;
  double walk_forward, walk_sideways, walk_backward; /* highest speeds, m/s, each >= 0 */
  double turn_rate;                  /* highest, rad/s */
  double decision_period;            /* s between two decisions of a robot */
  uint32_t packet_size;              /* bytes a packet may have */
  uint32_t packet_budget;            /* packets the team may send in a match */
  regista_span landmarks;            /* regista_landmark */
  regista_span roles;                /* regista_role; lives as long as the instance */
  double goal_post_radius;
  double ball_deceleration;          /* of a rolling ball, m/s^2 */
  uint32_t halves;                   /* of a match, without extra time */
  uint32_t reserved;
  double half_length;                /* s */
  double set_play_distance;          /* that opponents keep from the ball of a set play, m */
  double kick_reach;                 /* from the centre of the robot to that of a ball that it can kick, m */
  double kick_reach_angle;           /* to either side of its heading, within which it can kick, rad */
  double camera_half_angle;          /* of the horizontal field of view, rad */
  double camera_ball_range, camera_robot_range; /* m */
  double head_yaw;                   /* the camera turns up to this to either side, rad */
  double head_speed;                 /* rad/s */
  regista_span kicks;                /* regista_kick; may be empty */
  regista_span events;               /* regista_event_name: all that this host detects */
} regista_environment;

/* --- Worlds and frames ---------------------------------------------------------------------------------------- */

/* Phases and set plays of other leagues may follow: numbers from 1000 on are theirs. */
enum { REGISTA_PHASE_INITIAL = 0, REGISTA_PHASE_READY = 1, REGISTA_PHASE_SET = 2, REGISTA_PHASE_PLAYING = 3,
       REGISTA_PHASE_FINISHED = 4 };

enum { REGISTA_SET_PLAY_NONE = 0, REGISTA_SET_PLAY_KICK_OFF = 1, REGISTA_SET_PLAY_KICK_IN = 2,
       REGISTA_SET_PLAY_GOAL_KICK = 3, REGISTA_SET_PLAY_CORNER_KICK = 4, REGISTA_SET_PLAY_PUSHING_FREE_KICK = 5,
       REGISTA_SET_PLAY_PENALTY_KICK = 6 };

/* The game as the robot was told (late, over the network, except for the whistle). */
typedef struct regista_game {
  uint32_t size;
  int32_t phase;
  int32_t set_play;
  int32_t own_kick;                  /* 1: the set play, or the last kick-off, is the own team's; 0: the opponent's */
  int32_t half;                      /* from 1; beyond the environment's `halves`: extra time */
  int32_t own_score, opponent_score;
  int32_t reserved;
  double phase_time;                 /* s since phase or set play began */
  double time_left;                  /* s left in this half */
} regista_game;

enum {
  REGISTA_ROBOT_ACTIVE = 1,          /* can take a task: in play, not penalised, not given up for lost */
  REGISTA_ROBOT_PENALISED = 2,
  REGISTA_ROBOT_FALLEN = 4,
  REGISTA_ROBOT_SELF = 8,
  REGISTA_ROBOT_KNOWN = 16,          /* pose holds something: the robot was heard of at least once */
  REGISTA_ROBOT_HAS_TARGET = 32
};

/* A robot of the own team. All values are finite, also those of robots that are not known. */
typedef struct regista_robot {
  int32_t number;
  uint32_t flags;
  double pose[3];                    /* x, y, heading */
  double velocity[3];                /* vx, vy (field frame), turn rate */
  double covariance[6];              /* of the pose */
  double target[2];                  /* where it walks to, as last sent; if HAS_TARGET */
  double time_until_up;              /* s, 0 when it stands */
  double age;                        /* s since the last news of it; 0 for oneself in `mine` */
  int32_t role;                      /* role it last claimed, -1 = none */
  int32_t reserved;
  double role_since;                 /* time when it took that role */
} regista_robot;

typedef struct regista_opponent {
  int32_t label;                     /* of the track; not a shirt number */
  uint32_t flags;                    /* 0 */
  double position[2];
  double velocity[2];
  double covariance[3];              /* of the place */
  double weight;                     /* probability that it exists, (0, 1] */
  double age;                        /* s since it was last seen by anyone */
} regista_opponent;

enum { REGISTA_BALL_KNOWN = 1 };     /* someone believes to know where the ball is */

typedef struct regista_ball {
  uint32_t size;
  uint32_t flags;
  double position[2];
  double velocity[2];
  double covariance[10];             /* of the motion */
  double age;                        /* s since it was last seen by anyone whose news are in this world */
} regista_ball;

/* One consistent picture. `robots` always has team_size elements: robot n is element n - 1. */
typedef struct regista_world {
  uint32_t size;
  uint32_t reserved;
  const regista_game* game;
  const regista_ball* ball;
  regista_span robots;               /* regista_robot */
  regista_span opponents;            /* regista_opponent */
  regista_span active;               /* int32_t: numbers of the active robots, ascending; rows of matrices. The own
                                        number is missing while the robot is penalised, and from `common` also while
                                        its teammates must have given it up */
} regista_world;

enum {
  REGISTA_TASK_REQUIRED = 1,         /* never filtered away while a robot can take it */
  REGISTA_TASK_ALONG_EDGES = 2       /* the team wants robots to walk to it along the edges of the frame */
};

/* A role of the current context, with the place where it is to be played. */
typedef struct regista_task {
  int32_t id;                        /* row of the table of roles: stable through the match */
  int32_t priority;                  /* 0 is the most important */
  int32_t group;                     /* tasks of one group exclude each other for an auction by groups; -1 = none */
  int32_t robot;                     /* shirt number that alone may take it, 0 = any, -1 = nobody now */
  uint32_t flags;
  uint32_t reserved;
  double before[3];                  /* pose as the role's rule gives it */
  double after[3];                   /* the same moved towards the nearest waypoint; equal before the offset step */
} regista_task;

typedef struct regista_waypoint {
  double x, y;
  double score;                      /* >= 0, larger is better, 1 when the positioner has no opinion */
  int32_t task;                      /* index into the frame's tasks if the point belongs to one, else -1 */
  int32_t robot;                     /* shirt number if the point belongs to a robot, else 0 */
} regista_waypoint;

typedef struct regista_edge {
  uint32_t from, to;                 /* indices into the waypoints; undirected */
} regista_edge;

enum { REGISTA_MINE = 0, REGISTA_COMMON = 1 };

/* Parts of a frame. A descriptor says which of them its plugin reads; the others need not be made. They are null or
 * empty, and single numbers of them are anything, NaN when a host checks. All else of a frame is there for everybody. */
enum {
  REGISTA_READS_NOTHING = 0,
  REGISTA_READS_OPPONENTS_MINE = 1,  /* mine->opponents */
  REGISTA_READS_OPPONENTS_COMMON = 2,
  REGISTA_READS_COVARIANCES = 4,     /* of robots, opponents and balls of either world */
  REGISTA_READS_FACINGS = 8,         /* the third number of `before` and `after` of tasks */
  REGISTA_READS_TIMES = 16,          /* time_to_task */
  REGISTA_READS_WAYPOINTS = 32,
  REGISTA_READS_EDGES = 64,
  REGISTA_READS_PREVIOUS = 128,
  REGISTA_READS_ALL = 0x7fffffff     /* also what later versions add */
};

/* What a plugin sees at one decision of one robot. */
typedef struct regista_frame {
  uint32_t size;
  int32_t own_number;
  uint64_t tick;                     /* decisions of this robot so far */
  double time;
  int32_t knowledge;                 /* REGISTA_MINE or REGISTA_COMMON: the world this call is to be computed on */
  int32_t context;                   /* index of the context in force, -1 while none has been chosen */
  const regista_world* mine;         /* everything this robot believes */
  const regista_world* common;       /* only what has been sent and received: what all can know */
  regista_span tasks;                /* regista_task: all of the context for a positioner, else those kept */
  regista_span waypoints;            /* regista_waypoint; empty before the positioner */
  regista_span edges;                /* regista_edge */
  regista_span previous;             /* int32_t per robot (n - 1): task id in this robot's last assignment, -1 none */
  regista_matrix time_to_task;       /* s; rows: active robots of the chosen world, columns: tasks. 0 x 0 before the
                                        filter */
} regista_frame;

/* --- Predictor -------------------------------------------------------------------------------------------------- */

/* The own body's motion since the last call, by odometry, in the robot frame at its beginning. */
typedef struct regista_motion {
  double x, y, heading;
} regista_motion;

/* What the camera could see: a sector of a disc. */
typedef struct regista_visible_area {
  double x, y;                       /* apex: where the robot believes to be, field frame */
  double heading;                    /* of the camera's axis, field frame */
  double half_angle;                 /* rad */
  double range_ball, range_robot;    /* m */
} regista_visible_area;

enum {
  REGISTA_MEASURED_POSE = 1,         /* absolute pose: placed by hand, or re-entering. position and heading, field frame */
  REGISTA_MEASURED_LANDMARK = 2,     /* position in the robot frame; label = kind of the landmark */
  REGISTA_MEASURED_BALL = 3,         /* position in the field frame */
  REGISTA_MEASURED_ROBOT = 4         /* position in the field frame, of an opponent */
};

typedef struct regista_measurement {
  int32_t kind;
  int32_t label;
  double position[2];
  double heading;                    /* REGISTA_MEASURED_POSE only */
  double covariance[6];              /* of the pose; entries of the heading are 0 unless POSE. Contains the own pose's
                                        uncertainty where position is in the field frame */
} regista_measurement;

enum { REGISTA_TRACK_HAS_TARGET = 1, REGISTA_TRACK_VELOCITY = 2 /* the velocity is believed */ };

/* What only self and teammates have. */
typedef struct regista_track_pose {
  double heading, turn_rate;
  double heading_variance;
  double velocity_variance;          /* of vx and of vy */
  double target[2];                  /* teammates: where it said to walk to; if HAS_TARGET */
} regista_track_pose;

/* An estimate of one object's state. */
typedef struct regista_track {
  int32_t label;
  uint32_t flags;
  double x, y;                       /* |x|, |y| <= 1e4 */
  double vx, vy;                     /* field frame; |vx|, |vy| <= 1e4 */
  double weight;                     /* probability of existence, or of the hypothesis, (0, 1] */
  double age;                        /* s since the last observation behind it */
  double covariance[3];              /* of the place */
  union {
    double motion[7];                /* ball, opponents: the rest of the covariance of the motion */
    regista_track_pose pose;         /* self, teammates */
  };
} regista_track;

typedef struct regista_predictor {
  uint32_t size;
  uint32_t subjects;                 /* REGISTA_SUBJECT_* it can model */
  /* Carries the model dt > 0 seconds forward. `motion` is null when the own body is not the observer (the model of a
   * teammate). `last` is the frame of this robot's last decision, null before the first. */
  int32_t (*predict)(void* instance, double dt, const regista_motion* motion, const regista_frame* last,
                     regista_error* error);
  /* Takes what was measured now (regista_measurement, may be empty: a miss is news too). */
  int32_t (*correct)(void* instance, regista_span measurements, const regista_visible_area* area,
                     regista_error* error);
  /* Replaces the labels in `tracks` (regista_track) by what a packet said `age` >= 0 seconds ago, carried forward to
   * now: `tracks` is as it was then, and the plugin adds `age` to their ages. For subjects other than teammates
   * `tracks` replaces the whole model: the host has merged what was known before with what the packet said. */
  int32_t (*absorb)(void* instance, regista_span tracks, double age, regista_error* error);
  /* Writes the present estimate (regista_track). Ball: best hypothesis first. Teammates: ascending label. */
  int32_t (*tracks)(void* instance, regista_room* out, regista_error* error);
  /* May be null. For models of teammates: what `tracks` would give `age` seconds after absorb had taken `told` with age
   * 0, by a formula and without changing the model, so that only those are computed that somebody asks for. */
  int32_t (*track_at)(void* instance, const regista_track* told, double age, regista_track* out, regista_error* error);
} regista_predictor;

/* --- Context ---------------------------------------------------------------------------------------------------- */

typedef struct regista_context {
  uint32_t size;
  uint32_t reserved;
  /* *out = 1 when the condition holds now, else 0. Called once per decision for every context, so that it may keep
   * memory (hysteresis). The frame has no tasks yet. */
  int32_t (*holds)(void* instance, const regista_frame* frame, int32_t* out, regista_error* error);
} regista_context;

/* --- Positioner ------------------------------------------------------------------------------------------------- */

/* A region of the field that belongs to a robot: vertices [first, first + count), counter-clockwise. */
typedef struct regista_cell {
  int32_t robot;                     /* shirt number */
  uint32_t first, count;
} regista_cell;

typedef struct regista_vertex {
  double x, y;
} regista_vertex;

typedef struct regista_placement {
  uint32_t size;
  uint32_t reserved;
  regista_room points;               /* regista_waypoint, inside field and border strip; for 256 at least */
  regista_room edges;                /* regista_edge, each once, none to itself; for 512 at least */
  regista_room cells;                /* regista_cell; for 16 at least */
  regista_room vertices;             /* regista_vertex; for 512 at least */
} regista_placement;

typedef struct regista_positioner {
  uint32_t size;
  uint32_t reserved;
  int32_t (*place)(void* instance, const regista_frame* frame, regista_placement* out, regista_error* error);
} regista_positioner;

/* --- Utility ---------------------------------------------------------------------------------------------------- */

typedef struct regista_utility {
  uint32_t size;
  uint32_t reserved;
  /* Fills out(i, j) with the utility of active robot i for task j: in [0, 1e12], larger is better. All entries are 0
   * on entry. Called only with rows > 0 and columns > 0. */
  int32_t (*score)(void* instance, const regista_frame* frame, const regista_matrix_room* out, regista_error* error);
} regista_utility;

/* --- Assigner --------------------------------------------------------------------------------------------------- */

/* No task: the robot acts as robots without a role do. Unknown: negotiations have not told yet; the robot goes on with
 * the task it has while the filter keeps that, and else has none. */
enum { REGISTA_NO_TASK = -1, REGISTA_UNKNOWN_TASK = -2 };
enum { REGISTA_ASSIGNER_NEGOTIATES = 1 }; /* may show a task twice while robots have not agreed */

typedef struct regista_assigner {
  uint32_t size;
  uint32_t flags;                    /* REGISTA_ASSIGNER_* */
  /* utilities(i, j): finite and >= 0, or -INFINITY where robot i must not take task j. Writes to out[i] a column, or
   * REGISTA_NO_TASK / REGISTA_UNKNOWN_TASK; all entries are REGISTA_NO_TASK on entry. A column at most once unless
   * REGISTA_ASSIGNER_NEGOTIATES, never a forbidden pair. rows or columns may be 0. */
  int32_t (*assign)(void* instance, const regista_frame* frame, const regista_matrix* utilities, int32_t* out,
                    regista_error* error);
} regista_assigner;

/* --- Sender ----------------------------------------------------------------------------------------------------- */

/* What happened since the last decision, and, for a packet, why it was sent. */
enum {
  REGISTA_EVENT_PERIOD = 0,          /* as a reason: nothing but time passed */
  REGISTA_EVENT_WHISTLE = 1,         /* heard the whistle */
  REGISTA_EVENT_BALL_FOUND = 2,      /* in a context of searching, this robot sees the ball */
  REGISTA_EVENT_GOALKEEPER_SAW_BALL = 3, /* this robot is number 1 and sees the ball; value: s it was unseen */
  REGISTA_EVENT_BALL_KNOWN_AGAIN = 4, /* sees the ball that no teammate has reported; value: s the team lacked it */
  REGISTA_EVENT_ROLE_CHANGED = 5,    /* value: id of the new role */
  REGISTA_EVENT_BALL_MOVED = 6,      /* the own view of the ball left what the team believes; value: m between them */
  REGISTA_EVENT_POSE_MOVED = 7,      /* the own pose left what the team believes; value: m between them */
  REGISTA_EVENT_FELL = 8,
  REGISTA_EVENT_GOT_UP = 9,
  REGISTA_EVENT_PHASE_CHANGED = 10,  /* value: new phase */
  REGISTA_EVENT_CONTEXT_CHANGED = 11, /* value: index of the new context */
  REGISTA_EVENT_RETURNED = 12,       /* is back in play after a penalty */
  REGISTA_EVENT_OFFER = 13,          /* as a reason: a plugin's offer was urgent */
  REGISTA_EVENT_COUNT = 14,          /* of this version */
  REGISTA_REASON_OWN = 1000          /* as a reason: this and above are the sender's own `reasons` */
};

typedef struct regista_event {
  int32_t kind;
  int32_t reserved;
  double value;
} regista_event;

enum { REGISTA_MEDIUM_RADIO = 0 };   /* segments of packets; gestures will follow */

/* Bytes that a plugin wants its counterparts to have. */
typedef struct regista_offer {
  uint64_t handle;
  uint32_t bytes;                    /* length of the segment, with its two bytes of heading */
  int32_t medium;
  double urgency;                    /* [0, 1]; 1: worth a packet of its own */
  double expiry;                     /* time after which it is dropped */
} regista_offer;

typedef struct regista_budget {
  uint32_t size;
  int32_t packets_left;              /* of the whole team, as the game controller told */
  double line;                       /* packets that would be left if spent evenly over match_time_left, from its start */
  double match_time_left;            /* s in which a team may send: play, and the Ready and Set before each half, in
                                        which the clock stands; see share */
  double since_own;                  /* s since this robot sent; since the start of the match if never */
  double since_team;                 /* s since any packet was sent or heard */
  uint32_t bytes_free;               /* for segments with their headings, beside the largest core a packet can have */
  uint32_t reserved;
  double share;                      /* of a whole match's packets that this game has; (0, 1]. packets_left, line,
                                        match_time_left and the environment's packet_budget are of the share; what a
                                        plugin counts in packets of a match it scales itself. 1, too, where size ends
                                        before */
} regista_budget;

typedef struct regista_send {
  uint32_t size;
  int32_t send;                      /* 1: send a packet now */
  int32_t reason;                    /* REGISTA_EVENT_*, or REGISTA_REASON_OWN + index into the sender's reasons, for
                                        the account of packets */
  uint32_t granted_count;            /* comes in as 0 */
  uint64_t* granted;                 /* handles of offers to take along, in this order; capacity: offers.count. What
                                        does not fit in bytes_free stays pending */
} regista_send;

typedef struct regista_sender {
  uint32_t size;
  uint32_t reason_count;             /* at most 64 */
  /* When: see the head of this file. events: regista_event, offers: regista_offer. */
  int32_t (*decide)(void* instance, const regista_frame* frame, regista_span events, regista_span offers,
                    const regista_budget* budget, regista_send* out, regista_error* error);
  const char* const* reasons;        /* lower_snake_case: what packets are sent for, beside events; null when none */
} regista_sender;

/* --- Behaviour --------------------------------------------------------------------------------------------------- */

/* What the behaviour is for, to those who count: which roles play the ball, keep the goal, look for the ball. */
enum { REGISTA_BEHAVIOUR_PLAYS_BALL = 1, REGISTA_BEHAVIOUR_KEEPS_GOAL = 2, REGISTA_BEHAVIOUR_SEARCHES = 4 };

enum {
  REGISTA_BODY_SEES_BALL = 1,        /* in the image of this decision */
  REGISTA_BODY_BALL_REFUTED = 2,     /* looked where the ball of `mine` should be, and it is not there */
  REGISTA_BODY_FALLEN = 4,
  REGISTA_BODY_PENALISED = 8,
  REGISTA_BODY_KICKING = 16,         /* a kick is under way: motion and kick are ignored */
  REGISTA_BODY_TOUCHED = 32          /* feels a robot against its arms or feet, at `contact` */
};

typedef struct regista_point {
  double x, y;
} regista_point;

/* The own body, and what it is to do. */
typedef struct regista_body {
  uint32_t size;
  uint32_t flags;                    /* REGISTA_BODY_* */
  int32_t task;                      /* index into the frame's tasks; -1: the robot has none */
  int32_t reserved;
  double pose[3];                    /* where it believes to be: x, y, heading; field frame */
  double motion[3];                  /* since the last decision, by odometry, in the robot frame at its beginning */
  double head_yaw;                   /* of the camera now, relative to the body */
  double time_until_up;              /* s, 0 when it stands */
  double contact;                    /* rad, robot frame; if TOUCHED */
  regista_span robots_near;          /* regista_point, field frame: robots of either team, seen a moment ago */
} regista_body;

enum {
  REGISTA_MOTION_STAND = 0,
  REGISTA_MOTION_VELOCITY = 1,       /* moves with `velocity`, as far as the body can */
  REGISTA_MOTION_WALK_TO = 2         /* walks to `pose`: around robots, goals and `avoid`, and pushes nobody */
};

enum {
  REGISTA_WALK_BRISK = 1,            /* WALK_TO: at full speed, also on arrival */
  REGISTA_WALK_STRAIGHT = 2,         /* WALK_TO: around nobody */
  REGISTA_WALK_CREEP = 4             /* WALK_TO: turns as on the way to `pose`, but walks with velocity[0] and [1] */
};

/* A disc that the centre of the robot stays out of. */
typedef struct regista_disc {
  double x, y, radius;
} regista_disc;

enum { REGISTA_NO_KICK = -1, REGISTA_MOST_AVOIDED = 8 };

enum { REGISTA_ACTION_TARGET = 1 };  /* `target` is to be told to teammates instead of the task's place */

/* What the robot shall do until its next decision. */
typedef struct regista_action {
  uint32_t size;
  uint32_t flags;                    /* REGISTA_ACTION_* */
  int32_t motion;                    /* REGISTA_MOTION_* */
  uint32_t walk;                     /* REGISTA_WALK_* */
  double velocity[3];                /* forward, left, turn; robot frame */
  double pose[3];                    /* x, y, heading; field frame */
  double gaze;                       /* wanted heading of the camera relative to the body, in [-pi, pi] */
  int32_t kick;                      /* index into the environment's kicks, or REGISTA_NO_KICK */
  uint32_t avoid_count;
  double kick_direction;             /* in which the ball shall go, robot frame, in [-pi, pi] */
  double kick_distance;              /* that it shall roll: within the range of the kick */
  double target[2];                  /* field frame; if ACTION_TARGET */
  regista_disc avoid[REGISTA_MOST_AVOIDED]; /* WALK_TO: walked around like robots */
} regista_action;

typedef struct regista_behaviour {
  uint32_t size;
  uint32_t flags;                    /* REGISTA_BEHAVIOUR_* */
  /* Called at every decision, in every phase, also while the robot lies: of the behaviour that its role names, or of
   * the one that the team has for robots without a role, as while it is penalised. All of `out` is 0 on entry but its
   * size and kick = REGISTA_NO_KICK: the robot stands and looks ahead. Numbers that are used are at most 1e4 in size. A
   * kick begins when the ball is in reach, else the robot stands: `motion` is ignored while a kick is asked for. */
  int32_t (*act)(void* instance, const regista_frame* frame, const regista_body* body, regista_action* out,
                 regista_error* error);
} regista_behaviour;

/* --- Mailbox: for plugins of any kind --------------------------------------------------------------------------- */

typedef struct regista_message {
  int32_t sender;                    /* shirt number, never the own */
  int32_t medium;
  double time_sent, time_heard;
  const uint8_t* bytes;
  uint32_t count;
  uint32_t reserved;
} regista_message;

/* Broadcast only; nothing is acknowledged. Messages reach the instance of the plugin with the same id in the same place
 * of the teammates' teams. All instances of all contexts live from the beginning of a match and are counted in the
 * order of the team's page, so the place does not depend on which context is in force: an instance whose context is
 * not in force receives as well. receive runs while packets are heard, before the contexts are asked. */
typedef struct regista_mailbox {
  uint32_t size;
  uint32_t reserved;
  int32_t (*transmitted)(void* instance, uint64_t handle, regista_error* error); /* left in a packet just now */
  int32_t (*dropped)(void* instance, uint64_t handle, regista_error* error);     /* expired, replaced or withdrawn */
  int32_t (*receive)(void* instance, const regista_message* message, regista_error* error);
  /* May be null. What these bytes of this plugin say, in one line of UTF-8 for people, with its NUL at most `capacity`
   * bytes. Called only for recordings, and a recording must not change the match: so it changes nothing, and offer()
   * and withdraw() do nothing meanwhile. */
  int32_t (*describe)(void* instance, const uint8_t* bytes, uint32_t count, char* text, uint32_t capacity,
                      regista_error* error);
} regista_mailbox;

/* What an instance may call, only from within its own calls. Lives as long as the instance. */
typedef struct regista_host {
  uint32_t size;
  uint32_t reserved;
  void* context;                     /* first argument of every call below */
  /* Offers `count` bytes (copied) for a coming packet. `replaces`: an earlier handle, or 0. Returns a handle > 0, or 0
   * when refused (longer than any packet could take, urgency outside [0, 1], unknown medium, expired, or 64 offers of
   * this instance are pending). */
  uint64_t (*offer)(void* context, const uint8_t* bytes, uint32_t count, double urgency, double expiry,
                    int32_t medium, uint64_t replaces);
  void (*withdraw)(void* context, uint64_t handle); /* unknown handles are ignored */
  uint32_t (*bytes_free)(void* context);            /* longest segment with its heading that a packet could take now */
  /* The host's side of an extension, "regista.log/0", or null when it has none of that name. The same answer every
   * time; what it leads to lives as long as the instance. */
  const void* (*extension)(void* context, const char* id);
} regista_host;

/* --- Extensions ---------------------------------------------------------------------------------------------------- */

/* What only some need has a name: "regista.draw/0" is version 0, a draft, of the extension draw. Those of others stand
 * under their own prefix. Either side asks the other by name, gets a table whose layout belongs to the name, or null,
 * and does without. Headers: <regista/extensions/...>. Reserved names: regista.state, regista.reward (null except in
 * training: a mind may not learn the truth from it in play), regista.evaluate, regista.media. */

/* --- Descriptor ------------------------------------------------------------------------------------------------- */

enum { REGISTA_KIND_PREDICTOR = 1, REGISTA_KIND_CONTEXT = 2, REGISTA_KIND_POSITIONER = 3, REGISTA_KIND_UTILITY = 4,
       REGISTA_KIND_ASSIGNER = 5, REGISTA_KIND_SENDER = 6, REGISTA_KIND_MAILBOX = 7, REGISTA_KIND_BEHAVIOUR = 8,
       REGISTA_KIND_END = 9 };

enum { REGISTA_TYPE_REAL = 1, REGISTA_TYPE_INTEGER = 2, REGISTA_TYPE_BOOLEAN = 3, REGISTA_TYPE_CHOICE = 4,
       REGISTA_TYPE_TEXT = 5, REGISTA_TYPE_FILE = 6 };

enum { REGISTA_PARAMETER_TUNABLE = 1, REGISTA_PARAMETER_LOG_SCALE = 2 };

typedef struct regista_parameter {
  uint32_t size;
  int32_t type;
  const char* name;                  /* lower_snake_case */
  const char* unit;                  /* SI symbol, "1" for a plain number, "" where there is none */
  const char* doc;                   /* one sentence, with its source where a value is published */
  double minimum, maximum;           /* closed range; real and integer */
  double initial;                    /* default: real, integer, boolean (0 or 1), choice (index) */
  const char* initial_text;          /* default: text; null for file = none */
  const char* const* choices;        /* names, choice only */
  uint32_t choice_count;
  uint32_t flags;                    /* REGISTA_PARAMETER_* */
} regista_parameter;

/* The value of one parameter, checked by the host against its declaration. */
typedef struct regista_value {
  double number;                     /* real, integer, boolean, choice (index) */
  const char* text;                  /* text; content of a file; valid until create returns; else null */
  uint64_t text_size;                /* bytes, without the NUL that follows */
} regista_value;

typedef struct regista_descriptor {
  /* The first five fields keep their places in every major version, so that a refusal can name what it refuses. */
  uint32_t size;
  uint32_t abi_major, abi_minor;     /* what the plugin was built against */
  uint32_t parameter_count;
  const char* id;                    /* lower_snake_case, at most 64 characters, unique among plugins of its kinds */
  const char* version;               /* of the plugin, e.g. "1.2.0" */
  const char* summary;               /* one line; like the other texts UTF-8, at most 1000 bytes */
  const char* licence;               /* SPDX expression */
  const char* build_tag;             /* compiler and build type, for people who compare builds */
  const regista_parameter* parameters; /* `parameter_count` elements, each `parameter_stride` bytes after the last */
  uint32_t parameter_stride;
  uint32_t reserved;
  /* The table of calls of a kind, or null. Same answer every time; the table lives as long as the shared object. */
  const void* (*table)(int32_t kind);
  /* A new instance, or null after writing to error. values: regista_value, one for each parameter, in declared order. */
  void* (*create)(const regista_environment* environment, const regista_host* host, regista_span values,
                  regista_error* error);
  /* Back to the beginning of a match. */
  int32_t (*reset)(void* instance, uint64_t seed, regista_error* error);
  void (*destroy)(void* instance);
  uint32_t minimum_major, minimum_minor; /* the oldest version that has all it needs; counts from 1.0 on */
  uint32_t reads;                    /* REGISTA_READS_*: the parts of frames that it reads */
  uint32_t reserved_too;
  /* The plugin's side of an extension, or null. The same answer every time. May itself be null. */
  const void* (*extension)(const char* id);
} regista_descriptor;

/* Descriptor number `index`, null past the end. Called at any time after loading; always the same answer. A plugin
 * answers whatever the host's version: the host refuses what it cannot serve, and names both versions. */
#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const regista_descriptor* regista_plugin_entry(uint32_t host_major, uint32_t host_minor, uint32_t index);

#ifdef __cplusplus
}
#endif

#endif /* REGISTA_ABI_H */
