package org.starl.sim.export;

/** The JSON schemas of the messages in an MCAP file. */
final class McapSchemas {

  private static final String NUMBER = type("number");
  private static final String INTEGER = type("integer");
  private static final String TEXT = type("string");
  private static final String FLAG = type("boolean");
  private static final String OBJECTS = list(type("object"));

  private static final String TIME = fields("sec", INTEGER, "nsec", INTEGER);
  private static final String XYZ = fields("x", NUMBER, "y", NUMBER, "z", NUMBER);
  private static final String TURN = fields("x", NUMBER, "y", NUMBER, "z", NUMBER, "w", NUMBER);
  private static final String PLACE = fields("position", XYZ, "orientation", TURN);
  private static final String COLOUR = fields("r", NUMBER, "g", NUMBER, "b", NUMBER, "a", NUMBER);

  static final String POSE = fields("timestamp", TIME, "frame_id", TEXT, "pose", PLACE);

  static final String LOG =
      fields(
          "timestamp", TIME,
          "level", INTEGER,
          "message", TEXT,
          "name", TEXT,
          "file", TEXT,
          "line", INTEGER);

  static final String VARIABLE = fields("robot", TEXT, "source", TEXT, "name", TEXT, "value", TEXT);

  static final String MESSAGE =
      fields(
          "fate", TEXT, "from", TEXT, "to", TEXT, "channel", TEXT, "seq", INTEGER, "bytes", INTEGER,
          "text", TEXT, "why", TEXT);

  private static final String DELETIONS =
      list(fields("timestamp", TIME, "type", INTEGER, "id", TEXT));
  private static final String METADATA = list(fields("key", TEXT, "value", TEXT));
  private static final String COLOURS = list(COLOUR);
  private static final String POINTS = list(XYZ);
  private static final String INDICES = list(INTEGER);

  private static final String ARROWS =
      list(
          fields(
              "pose", PLACE,
              "shaft_length", NUMBER,
              "shaft_diameter", NUMBER,
              "head_length", NUMBER,
              "head_diameter", NUMBER,
              "color", COLOUR));

  private static final String CYLINDERS =
      list(
          fields(
              "pose", PLACE,
              "size", XYZ,
              "bottom_scale", NUMBER,
              "top_scale", NUMBER,
              "color", COLOUR));

  private static final String LINES =
      list(
          fields(
              "type", INTEGER,
              "pose", PLACE,
              "thickness", NUMBER,
              "scale_invariant", FLAG,
              "points", POINTS,
              "color", COLOUR,
              "colors", COLOURS,
              "indices", INDICES));

  private static final String TEXTS =
      list(
          fields(
              "pose", PLACE,
              "billboard", FLAG,
              "font_size", NUMBER,
              "scale_invariant", FLAG,
              "color", COLOUR,
              "text", TEXT));

  private static final String ENTITIES =
      list(
          fields(
              "timestamp", TIME,
              "frame_id", TEXT,
              "id", TEXT,
              "lifetime", TIME,
              "frame_locked", FLAG,
              "metadata", METADATA,
              "arrows", ARROWS,
              "cubes", OBJECTS,
              "spheres", OBJECTS,
              "cylinders", CYLINDERS,
              "lines", LINES,
              "triangles", OBJECTS,
              "texts", TEXTS,
              "models", OBJECTS));

  static final String SCENE = fields("deletions", DELETIONS, "entities", ENTITIES);

  private McapSchemas() {}

  private static String type(String name) {
    return "{\"type\":\"" + name + "\"}";
  }

  private static String list(String of) {
    return "{\"type\":\"array\",\"items\":" + of + "}";
  }

  /** Names and schemas alternate. */
  private static String fields(String... namesAndSchemas) {
    StringBuilder schema = new StringBuilder("{\"type\":\"object\",\"properties\":{");
    for (int i = 0; i < namesAndSchemas.length; i += 2) {
      schema.append(i == 0 ? "\"" : ",\"").append(namesAndSchemas[i]).append("\":");
      schema.append(namesAndSchemas[i + 1]);
    }
    return schema.append("}}").toString();
  }
}
