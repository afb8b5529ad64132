package org.starl.sim.export;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.sim.export.MessageSink.Schema;

/** Foxglove's messages become those of ROS 2; .ci/run reads a whole bag with an independent reader. */
class RosBagTest {

  private final List<String> topics = new ArrayList<>();
  private final List<String> definitions = new ArrayList<>();
  private final List<ByteBuffer> written = new ArrayList<>();
  private final RosBag bag =
      new RosBag(
          new RosBag.Encoded() {
            @Override
            public int channel(String topic, String schemaName, String definition) {
              topics.add(topic + " " + schemaName);
              definitions.add(definition);
              return topics.size();
            }

            @Override
            public void message(int channel, long timeNs, byte[] message) {
              written.add(ByteBuffer.wrap(message).order(ByteOrder.LITTLE_ENDIAN));
            }
          });

  private ByteBuffer cdr(Schema schema, String json) {
    int channel = bag.channel("/a", schema);
    bag.message(channel, 5, object(json));
    ByteBuffer message = written.getLast();
    assertThat(message.getInt()).as("little endian, plain CDR").isEqualTo(0x100);
    return message;
  }

  private static ObjectNode object(String json) {
    try {
      return (ObjectNode) new ObjectMapper().readTree(json.replace('\'', '"'));
    } catch (JsonProcessingException e) {
      throw new IllegalArgumentException(json, e);
    }
  }

  private static String text(ByteBuffer in) {
    byte[] bytes = new byte[aligned(in, 4).getInt() - 1];
    in.get(bytes);
    assertThat(in.get()).isZero();
    return new String(bytes, StandardCharsets.UTF_8);
  }

  private static ByteBuffer aligned(ByteBuffer in, int bytes) {
    return in.position((in.position() - 4 + bytes - 1) / bytes * bytes + 4);
  }

  private static void doubles(ByteBuffer in, double... expected) {
    for (double number : expected) {
      assertThat(aligned(in, 8).getDouble()).isEqualTo(number);
    }
  }

  private static final String POSE =
      "'pose':{'position':{'x':1,'y':-2.5,'z':0},'orientation':{'x':0,'y':0,'z':0.6,'w':0.8}}";

  @Test
  void posesAreStamped() {
    ByteBuffer in =
        cdr(McapSchemas.POSE, "{'timestamp':{'sec':3,'nsec':50},'frame_id':'world'," + POSE + "}");
    assertThat(List.of(in.getInt(), in.getInt())).containsExactly(3, 50);
    assertThat(text(in)).isEqualTo("world");
    doubles(in, 1, -2.5, 0, 0, 0, 0.6, 0.8);
    assertThat(in.hasRemaining()).isFalse();
    assertThat(definitions.get(0))
        .startsWith("std_msgs/Header header\ngeometry_msgs/Pose pose\n=====")
        .contains("=\nMSG: geometry_msgs/Quaternion\nfloat64 x\n");
    assertThat(topics).containsExactly("/a geometry_msgs/msg/PoseStamped");
  }

  @Test
  void framesHaveTheirParent() {
    ByteBuffer in =
        cdr(
            McapSchemas.TRANSFORMS,
            "{'transforms':[{'timestamp':{'sec':1,'nsec':2},'parent_frame_id':'world',"
                + "'child_frame_id':'bot0','translation':{'x':1,'y':2,'z':0},"
                + "'rotation':{'x':0,'y':0,'z':0,'w':1}}]}");
    assertThat(List.of(in.getInt(), in.getInt(), in.getInt())).containsExactly(1, 1, 2);
    assertThat(text(in)).isEqualTo("world");
    assertThat(text(in)).isEqualTo("bot0");
    doubles(in, 1, 2, 0, 0, 0, 0, 1);
    assertThat(in.hasRemaining()).isFalse();
  }

  @Test
  void numbersCanBePlottedAndOtherValuesAreText() {
    ObjectNode number = object("{'name':'x','value':7.5}");
    Schema ofNumbers = McapSchemas.variable(number.get("value"));
    doubles(cdr(ofNumbers, number.toString()), 7.5);
    assertThat(text(cdr(McapSchemas.MESSAGE, "{'fate':'s\u00fc\u00df'}")))
        .isEqualTo("{\"fate\":\"s\u00fc\u00df\"}");
    ByteBuffer log =
        cdr(
            McapSchemas.LOG,
            "{'timestamp':{'sec':1,'nsec':0},'level':4,'message':'m','name':'n','file':'','line':0}");
    assertThat(log.get(12)).as("rcl_interfaces' ERROR").isEqualTo((byte) 40);
    assertThat(text(log.position(13))).isEqualTo("n");
    assertThat(text(log)).isEqualTo("m");
    assertThat(topics)
        .containsExactly(
            "/a std_msgs/msg/Float64", "/a_2 std_msgs/msg/String", "/a_3 rcl_interfaces/msg/Log");
  }

  /** What a later message of an entity lacks is deleted, for markers stay. */
  @Test
  void scenesAreMarkers() {
    String time = "'timestamp':{'sec':1,'nsec':0},'frame_id':'world','lifetime':{'sec':0,'nsec':0}";
    String none = "'arrows':[],'cylinders':[],'triangles':[],'texts':[],'lines':[";
    String line =
        "{'type':1,"
            + POSE
            + ",'thickness':0.02,'points':[{'x':0,'y':0,'z':0},{'x':1,'y':0,'z':0}],"
            + "'color':{'r':1,'g':0,'b':0,'a':1}}";
    String update = "{'deletions':[],'entities':[{'id':'a'," + time + "," + none;
    ByteBuffer in = cdr(McapSchemas.SCENE, update + line + "," + line + "]}]}");
    assertThat(in.getInt()).isEqualTo(2);
    aligned(in.position(in.position() + 8), 4);
    assertThat(text(in)).isEqualTo("world");
    assertThat(text(in)).as("namespace").isEqualTo("a");
    aligned(in, 4);
    assertThat(List.of(in.getInt(), in.getInt(), in.getInt()))
        .as("id, type, action")
        .containsExactly(0, 4, 0);
    doubles(in, 1, -2.5, 0, 0, 0, 0.6, 0.8, 0.02, 1, 1);
    assertThat(in.getFloat()).as("red").isEqualTo(1);
    in.position(in.position() + 3 * 4 + 8 + 1);
    assertThat(aligned(in, 4).getInt()).as("points of the closed line").isEqualTo(3);
    bag.message(1, 6, object(update + line + "]}]}"));
    in = written.getLast().position(4);
    assertThat(in.getInt()).as("one, and a deletion").isEqualTo(2);
  }

  @Test
  void namesAreThoseOfRos() {
    bag.channel("/map", McapSchemas.SCENE);
    bag.channel("/variables/bot-1/m.__x/0", McapSchemas.variable(object("{}")));
    bag.message(1, 7, object("{'deletions':[],'entities':[]}"));
    bag.message(1, 9, object("{'deletions':[],'entities':[]}"));
    assertThat(topics)
        .containsExactly(
            "/obstacles visualization_msgs/msg/MarkerArray",
            "/variables/bot_1/m_x/n0 std_msgs/msg/String");
    assertThat(bag.metadata("run.mcap"))
        .contains(
            "nanoseconds_since_epoch: 7",
            "duration: {nanoseconds: 2}",
            "  message_count: 2\n",
            "relative_file_paths: [run.mcap]");
  }
}
