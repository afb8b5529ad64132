package org.starl.sim.export;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Turns the messages of {@link FoxgloveRecorder} into those of ROS 2, in its binary form (CDR), for a bag of
 * rosbag2. Scenes become {@code visualization_msgs/MarkerArray}, poses {@code geometry_msgs/PoseStamped}, frames {@code
 * tf2_msgs/TFMessage}, log lines {@code rcl_interfaces/Log}, variables that are numbers {@code
 * std_msgs/Float64}, and all else {@code std_msgs/String} with JSON. One table of definitions is written into the file and
 * decides how messages are encoded.
 */
final class RosBag implements MessageSink {

  private static final Map<String, String> FIELDS = new TreeMap<>();

  static {
    define("builtin_interfaces/Time", "int32 sec, uint32 nanosec");
    define("builtin_interfaces/Duration", "int32 sec, uint32 nanosec");
    define("std_msgs/Header", "builtin_interfaces/Time stamp, string frame_id");
    define("std_msgs/String", "string data");
    define("std_msgs/Float64", "float64 data");
    define("std_msgs/ColorRGBA", "float32 r, float32 g, float32 b, float32 a");
    define("geometry_msgs/Point", "float64 x, float64 y, float64 z");
    define("geometry_msgs/Vector3", "float64 x, float64 y, float64 z");
    define("geometry_msgs/Quaternion", "float64 x, float64 y, float64 z, float64 w");
    define(
        "geometry_msgs/Pose", "geometry_msgs/Point position, geometry_msgs/Quaternion orientation");
    define("geometry_msgs/PoseStamped", "std_msgs/Header header, geometry_msgs/Pose pose");
    define(
        "geometry_msgs/Transform",
        "geometry_msgs/Vector3 translation, geometry_msgs/Quaternion rotation");
    define(
        "geometry_msgs/TransformStamped",
        "std_msgs/Header header, string child_frame_id, geometry_msgs/Transform transform");
    define("tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms");
    define(
        "rcl_interfaces/Log",
        "builtin_interfaces/Time stamp, uint8 level, string name, string msg, string file, string"
            + " function, uint32 line");
    define("sensor_msgs/CompressedImage", "std_msgs/Header header, string format, uint8[] data");
    define("visualization_msgs/UVCoordinate", "float32 u, float32 v");
    define("visualization_msgs/MeshFile", "string filename, uint8[] data");
    define(
        "visualization_msgs/Marker",
        "std_msgs/Header header, string ns, int32 id, int32 type, int32 action, geometry_msgs/Pose"
            + " pose, geometry_msgs/Vector3 scale, std_msgs/ColorRGBA color,"
            + " builtin_interfaces/Duration lifetime, bool frame_locked, geometry_msgs/Point[]"
            + " points, std_msgs/ColorRGBA[] colors, string texture_resource,"
            + " sensor_msgs/CompressedImage texture, visualization_msgs/UVCoordinate[]"
            + " uv_coordinates, string text, string mesh_resource, visualization_msgs/MeshFile"
            + " mesh_file, bool mesh_use_embedded_materials");
    define("visualization_msgs/MarkerArray", "visualization_msgs/Marker[] markers");
  }

  /** ROS 2's types of Foxglove's. */
  private static final Map<String, String> TYPES =
      Map.of(
          "foxglove.SceneUpdate", "visualization_msgs/MarkerArray",
          "foxglove.PoseInFrame", "geometry_msgs/PoseStamped",
          "foxglove.FrameTransforms", "tf2_msgs/TFMessage",
          "foxglove.Log", "rcl_interfaces/Log");

  /** ROS 2's names of fields, and Foxglove's; empty for a part whose fields are in the message itself. */
  private static final Map<String, String> NAMES =
      Map.of(
          "header", "",
          "transform", "",
          "stamp", "timestamp",
          "nanosec", "nsec",
          "msg", "message",
          "frame_id", "parent_frame_id");

  private static final int DELETE = 2;
  private static final int LINES = 4;
  private static final double LABEL_M = 0.15;

  /** The kinds of an entity's parts, with the numbers of their markers. */
  private static final Map<String, Integer> MARKERS =
      new TreeMap<>(
          Map.of("arrows", 0, "cylinders", 3, "lines", LINES, "texts", 9, "triangles", 11));

  private record Topic(String name, String type) {}

  /** Takes encoded messages: a file. */
  interface Encoded {

    /** As {@link MessageSink#channel}, with a definition of ROS 2. */
    int channel(String topic, String type, String definition);

    void message(int channel, long timeNs, byte[] message);
  }

  private final Encoded file;
  private final ObjectMapper json = new ObjectMapper();
  private final List<Topic> topics = new ArrayList<>();
  private final Map<Topic, Long> counts = new LinkedHashMap<>();
  private final Map<String, Integer> markers = new TreeMap<>();
  private long count;
  private long firstNs;
  private long lastNs;

  RosBag(Encoded file) {
    this.file = file;
  }

  private static void define(String type, String fields) {
    FIELDS.put(type, fields);
  }

  /** The types and names of a type's fields. */
  private static String[] fields(String type) {
    return FIELDS.getOrDefault(type, "").split(", ", -1);
  }

  @Override
  public int channel(String topic, Schema schema) {
    String type =
        TYPES.getOrDefault(
            schema.name(), schema.isNumber() ? "std_msgs/Float64" : "std_msgs/String");
    // Names of ROS 2 have no '-', no '__', and no digit first; /map is taken for an occupancy grid.
    String name = topic.equals("/map") ? "/obstacles" : topic;
    name = name.replaceAll("[^A-Za-z0-9/]+", "_").replaceAll("/(?=[0-9])", "/n");
    String free = name;
    for (int i = 2; isTaken(free); i++) {
      free = name + "_" + i;
    }
    topics.add(new Topic(free, type));
    counts.put(topics.getLast(), 0L);
    return file.channel(free, type.replace("/", "/msg/"), definition(type));
  }

  private boolean isTaken(String name) {
    return topics.stream().anyMatch(topic -> topic.name().equals(name));
  }

  /** The definition of a type and, after it, those of its parts. */
  private static String definition(String type) {
    Set<String> all = new LinkedHashSet<>(List.of(type));
    StringBuilder text = new StringBuilder();
    for (List<String> left = new ArrayList<>(all); !left.isEmpty(); ) {
      String next = left.removeFirst();
      if (!next.equals(type)) {
        text.append("=".repeat(80)).append("\nMSG: ").append(next).append('\n');
      }
      for (String field : fields(next)) {
        text.append(field).append('\n');
        String part = field.replaceFirst("(\\[\\])? .*", "");
        if (FIELDS.containsKey(part) && all.add(part)) {
          left.add(part);
        }
      }
    }
    return text.toString();
  }

  @Override
  public void message(int channel, long timeNs, ObjectNode message) {
    Topic topic = topics.get(channel - 1);
    Cdr cdr = new Cdr();
    cdr.put(topic.type(), converted(topic, message));
    file.message(channel, timeNs, cdr.toByteArray());
    firstNs = count == 0 ? timeNs : firstNs;
    lastNs = timeNs;
    count++;
    counts.merge(topic, 1L, Long::sum);
  }

  private JsonNode converted(Topic topic, ObjectNode node) {
    return switch (topic.type()) {
      case "visualization_msgs/MarkerArray" -> markers(topic, node);
      case "rcl_interfaces/Log" -> node.put("level", 10 * node.get("level").asInt());
      case "std_msgs/Float64" -> json.createObjectNode().set("data", node.get("value"));
      case "std_msgs/String" -> json.createObjectNode().put("data", node.toString());
      default -> node;
    };
  }

  private ObjectNode markers(Topic topic, JsonNode update) {
    ObjectNode message = json.createObjectNode();
    ArrayNode all = message.putArray("markers");
    update.get("deletions").forEach(gone -> delete(topic, all, gone, 0));
    for (JsonNode entity : update.get("entities")) {
      int from = all.size();
      MARKERS.forEach((kind, type) -> {
        for (JsonNode part : entity.get(kind)) {
          ObjectNode marker = all.addObject();
          marker.setAll((ObjectNode) part);
          marker.set("timestamp", entity.get("timestamp"));
          marker.put("frame_id", entity.get("frame_id").asText());
          marker.put("ns", entity.get("id").asText()).put("id", all.size() - 1 - from);
          complete(marker, part, type);
        }
      });
      delete(topic, all, entity, all.size() - from);
    }
    return message;
  }

  private static void complete(ObjectNode marker, JsonNode part, int type) {
    marker.put("type", type);
    if (type == LINES && part.get("type").asInt() == 1) {
      ArrayNode closed = marker.withArray("points");
      if (!closed.isEmpty()) {
        closed.add(closed.get(0));
      }
    }
    double x = part.path("thickness").asDouble(1);
    double y = 1;
    double z = 1;
    if (part.has("shaft_length")) {
      x = part.get("shaft_length").asDouble() + part.get("head_length").asDouble();
      y = part.get("head_diameter").asDouble();
      z = y;
    } else if (part.has("font_size")) {
      z = part.get("scale_invariant").asBoolean() ? LABEL_M : part.get("font_size").asDouble();
    }
    if (part.has("size")) {
      marker.set("scale", part.get("size"));
    } else {
      marker.putObject("scale").put("x", x).put("y", y).put("z", z);
    }
  }

  /** Deletes those markers of an entity that its last message had and this one has not. */
  private void delete(Topic topic, ArrayNode all, JsonNode entity, int now) {
    String name = entity.get("id").asText();
    Integer before = markers.put(topic.name() + " " + name, now);
    for (int i = now; before != null && i < before; i++) {
      ObjectNode gone = all.addObject().put("ns", name).put("id", i).put("action", DELETE);
      gone.set("timestamp", entity.get("timestamp"));
    }
  }

  /** The file {@code metadata.yaml} beside the data; to be called after the last message. */
  String metadata(String dataFile) {
    StringBuilder yaml = new StringBuilder("rosbag2_bagfile_information:\n  version: 5\n");
    String times =
        "duration: {nanoseconds: %d}\n%sstarting_time: {nanoseconds_since_epoch: %d}\n%smessage_count: %d\n";
    yaml.append("  storage_identifier: mcap\n  ");
    yaml.append(times.formatted(lastNs - firstNs, "  ", firstNs, "  ", count));
    yaml.append("  topics_with_message_count:\n");
    counts.forEach((topic, messages) ->
        yaml.append("    - topic_metadata: {name: ")
            .append(topic.name())
            .append(", type: ")
            .append(topic.type().replace("/", "/msg/"))
            .append(", serialization_format: cdr, offered_qos_profiles: ''}\n")
            .append("      message_count: " + messages + "\n"));
    yaml.append("  compression_format: ''\n  compression_mode: ''\n");
    yaml.append("  relative_file_paths: [" + dataFile + "]\n");
    yaml.append("  files:\n    - path: " + dataFile + "\n      ");
    yaml.append(times.formatted(lastNs - firstNs, "      ", firstNs, "      ", count));
    return yaml.toString();
  }

  /** A message in the Common Data Representation: each number aligned to its size, little endian. */
  private static final class Cdr extends ByteArrayOutputStream {

    private static final int HEADER_BYTES = 4;

    Cdr() {
      writeBytes(new byte[] {0, 1, 0, 0});
    }

    void put(String type, JsonNode value) {
      if (type.endsWith("[]")) {
        number(value.size(), 4);
        value.forEach(item -> put(type.substring(0, type.length() - 2), item));
        return;
      }
      switch (type) {
        case "bool" -> write(value.asBoolean() ? 1 : 0);
        case "uint8" -> write(value.asInt());
        case "int32", "uint32" -> number(value.asLong(), 4);
        case "float32" -> number(Float.floatToIntBits((float) value.asDouble()), 4);
        case "float64" -> number(Double.doubleToLongBits(value.asDouble()), 8);
        case "string" -> {
          byte[] utf8 = value.asText().getBytes(StandardCharsets.UTF_8);
          number(utf8.length + 1, 4);
          writeBytes(utf8);
          write(0);
        }
        default -> {
          for (String field : fields(type)) {
            String[] words = field.split(" ", -1);
            put(words[0], part(value, words[1]));
          }
        }
      }
    }

    private static JsonNode part(JsonNode of, String name) {
      JsonNode part = of.path(name);
      String other = NAMES.get(name);
      if (!part.isMissingNode() || other == null) {
        return part;
      }
      return other.isEmpty() ? of : of.path(other);
    }

    private void number(long value, int bytes) {
      while ((count - HEADER_BYTES) % bytes != 0) {
        write(0);
      }
      for (int i = 0; i < bytes; i++) {
        write((int) (value >>> (8 * i)));
      }
    }
  }
}
