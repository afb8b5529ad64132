package org.starl.sim.export;

/** The JSON schemas of the messages in an MCAP file. */
final class McapSchemas {

  private static final String NUMBER = object("number");
  private static final String INTEGER = object("integer");
  private static final String TEXT = object("string");
  private static final String FLAG = object("boolean");
  private static final String TIME = fields("sec", INTEGER, "nsec", INTEGER);
  private static final String XYZ = fields("x", NUMBER, "y", NUMBER, "z", NUMBER);
  private static final String POSE_ONLY =
      fields(
          "position",
          XYZ,
          "orientation",
          fields("x", NUMBER, "y", NUMBER, "z", NUMBER, "w", NUMBER));
  private static final String COLOUR = fields("r", NUMBER, "g", NUMBER, "b", NUMBER, "a", NUMBER);

  static final String POSE = fields("timestamp", TIME, "frame_id", TEXT, "pose", POSE_ONLY);

  static final String LOG =
      fields(
          "timestamp",
          TIME,
          "level",
          INTEGER,
          "message",
          TEXT,
          "name",
          TEXT,
          "file",
          TEXT,
          "line",
          INTEGER);

  static final String VARIABLE = fields("robot", TEXT, "source", TEXT, "name", TEXT, "value", TEXT);

  static final String MESSAGE =
      fields(
          "fate", TEXT, "from", TEXT, "to", TEXT, "channel", TEXT, "seq", INTEGER, "bytes", INTEGER,
          "text", TEXT, "why", TEXT);

  static final String SCENE =
      fields(
          "deletions",
          list(fields("timestamp", TIME, "type", INTEGER, "id", TEXT)),
          "entities",
          list(
              fields(
                  "timestamp",
                  TIME,
                  "frame_id",
                  TEXT,
                  "id",
                  TEXT,
                  "lifetime",
                  TIME,
                  "frame_locked",
                  FLAG,
                  "metadata",
                  list(fields("key", TEXT, "value", TEXT)),
                  "arrows",
                  list(
                      fields(
                          "pose",
                          POSE_ONLY,
                          "shaft_length",
                          NUMBER,
                          "shaft_diameter",
                          NUMBER,
                          "head_length",
                          NUMBER,
                          "head_diameter",
                          NUMBER,
                          "color",
                          COLOUR)),
                  "cubes",
                  list(object("object")),
                  "spheres",
                  list(object("object")),
                  "cylinders",
                  list(
                      fields(
                          "pose",
                          POSE_ONLY,
                          "size",
                          XYZ,
                          "bottom_scale",
                          NUMBER,
                          "top_scale",
                          NUMBER,
                          "color",
                          COLOUR)),
                  "lines",
                  list(
                      fields(
                          "type",
                          INTEGER,
                          "pose",
                          POSE_ONLY,
                          "thickness",
                          NUMBER,
                          "scale_invariant",
                          FLAG,
                          "points",
                          list(XYZ),
                          "color",
                          COLOUR,
                          "colors",
                          list(COLOUR),
                          "indices",
                          list(INTEGER))),
                  "triangles",
                  list(object("object")),
                  "texts",
                  list(
                      fields(
                          "pose",
                          POSE_ONLY,
                          "billboard",
                          FLAG,
                          "font_size",
                          NUMBER,
                          "scale_invariant",
                          FLAG,
                          "color",
                          COLOUR,
                          "text",
                          TEXT)),
                  "models",
                  list(object("object")))));

  private McapSchemas() {}

  private static String object(String type) {
    return "{\"type\":\"" + type + "\"}";
  }

  private static String list(String of) {
    return "{\"type\":\"array\",\"items\":" + of + "}";
  }

  /** Names and schemas in turn. */
  private static String fields(String... namesAndSchemas) {
    StringBuilder schema = new StringBuilder("{\"type\":\"object\",\"properties\":{");
    for (int i = 0; i < namesAndSchemas.length; i += 2) {
      schema.append(i == 0 ? "\"" : ",\"").append(namesAndSchemas[i]).append("\":");
      schema.append(namesAndSchemas[i + 1]);
    }
    return schema.append("}}").toString();
  }
}
