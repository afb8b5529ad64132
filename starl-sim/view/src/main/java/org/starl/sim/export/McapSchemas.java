package org.starl.sim.export;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Collectors;
import org.starl.sim.export.MessageSink.Schema;

/** The JSON schemas of the messages for Foxglove. */
final class McapSchemas {

  // Foxglove refuses an object without properties; it shows more than are named.
  private static final String ANY_OBJECT = "{\"type\":\"object\",\"properties\":{}}";

  private static final Map<String, String> TYPES = new LinkedHashMap<>();

  static {
    for (String type : new String[] {"number", "integer", "string", "boolean"}) {
      TYPES.put(type, type(type));
    }
    TYPES.put("object", ANY_OBJECT);
    define("Time", "sec integer, nsec integer");
    define("Xyz", "x number, y number, z number");
    define("Turn", "x number, y number, z number, w number");
    define("Pose", "position Xyz, orientation Turn");
    define("Colour", "r number, g number, b number, a number");
    define("Deletion", "timestamp Time, type integer, id string");
    define("Culprit", "robot string, true number[], believed number[], error_mm number");
    define("Metadata", "key string, value string");
    define(
        "Arrow",
        "pose Pose, shaft_length number, shaft_diameter number, head_length number,"
            + " head_diameter number, color Colour");
    define("Cylinder", "pose Pose, size Xyz, bottom_scale number, top_scale number, color Colour");
    define(
        "Line",
        "type integer, pose Pose, thickness number, scale_invariant boolean, points Xyz[],"
            + " color Colour, colors Colour[], indices integer[]");
    define(
        "Triangles", "pose Pose, points Xyz[], color Colour, colors Colour[], indices integer[]");
    define(
        "Transform",
        "timestamp Time, parent_frame_id string, child_frame_id string, translation Xyz,"
            + " rotation Turn");
    define(
        "Text",
        "pose Pose, billboard boolean, font_size number, scale_invariant boolean, color Colour,"
            + " text string");
    define(
        "Entity",
        "timestamp Time, frame_id string, id string, lifetime Time, frame_locked boolean,"
            + " metadata Metadata[], arrows Arrow[], cubes object[], spheres object[],"
            + " cylinders Cylinder[], lines Line[], triangles Triangles[], texts Text[],"
            + " models object[]");
  }

  static final Schema POSE =
      schema("foxglove.PoseInFrame", "timestamp Time, frame_id string, pose Pose");
  static final Schema LOG =
      schema(
          "foxglove.Log",
          "timestamp Time, level integer, message string, name string, file string, line integer");
  static final Schema MESSAGE =
      schema(
          "starl.Message",
          "fate string, from string, to string, channel string, seq integer, bytes integer,"
              + " text string, message object, why string");
  static final Schema TRANSFORMS = schema("foxglove.FrameTransforms", "transforms Transform[]");
  static final Schema FAILURE =
      schema(
          "starl.Failure",
          "kind string, lemma string, sentence string, headline string, at_s number,"
              + " robots Culprit[], region string, faults string[], cause string,"
              + " commands string[]");
  static final Schema SCENE =
      schema("foxglove.SceneUpdate", "deletions Deletion[], entities Entity[]");

  private McapSchemas() {}

  /** Of a variable whose values are like {@code value}: Foxglove needs a type for each field. */
  static Schema variable(JsonNode value) {
    String fields = properties("robot string, source string, name string");
    String json = object(fields + ",\"value\":" + like(value));
    return new Schema("starl.Variable", json, value.isNumber());
  }

  private static String like(JsonNode value) {
    if (value.isObject()) {
      return object(
          value.properties().stream()
              .map(part -> TextNode.valueOf(part.getKey()) + ":" + like(part.getValue()))
              .collect(Collectors.joining(",")));
    }
    if (value.isArray()) {
      // Foxglove refuses lists of lists, and leaves an object without named properties as it is.
      boolean isPlain = !value.isEmpty() && !value.get(0).isArray();
      String items = isPlain ? like(value.get(0)) : ANY_OBJECT;
      return "{\"type\":\"array\",\"items\":" + items + "}";
    }
    return type(value.isNumber() ? "number" : value.isBoolean() ? "boolean" : "string");
  }

  private static String type(String name) {
    return "{\"type\":\"" + name + "\"}";
  }

  private static void define(String type, String fields) {
    TYPES.put(type, object(properties(fields)));
  }

  private static Schema schema(String name, String fields) {
    return new Schema(name, object(properties(fields)), false);
  }

  private static String object(String properties) {
    return "{\"type\":\"object\",\"properties\":{" + properties + "}}";
  }

  /** {@code fields} are names and types, {@code []} marks a list. */
  private static String properties(String fields) {
    return Arrays.stream(fields.split(", ", -1))
        .map(McapSchemas::field)
        .collect(Collectors.joining(","));
  }

  private static String field(String nameAndType) {
    String[] words = nameAndType.split(" ", -1);
    boolean isList = words[1].endsWith("[]");
    String type = TYPES.get(words[1].replace("[]", ""));
    return "\""
        + words[0]
        + "\":"
        + (isList ? "{\"type\":\"array\",\"items\":" + type + "}" : type);
  }
}
