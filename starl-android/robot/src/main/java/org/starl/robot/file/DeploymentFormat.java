package org.starl.robot.file;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.input.Field;
import org.starl.input.Form;
import org.starl.input.Form.Address;
import org.starl.input.Form.Kinds;
import org.starl.input.Form.Lines;
import org.starl.robot.udp.PublicRobotKey;

/** Every line that a deployment file can have: {@link DeploymentReader} and the JSON schema use these. */
public final class DeploymentFormat {

  static final String NATNET = "natnet";
  static final String JSON = "json";
  static final String CREATE = "create";
  static final String SIMULATED = "simulated";

  static final String ROS2 = "ros2";
  static final String DIRECT = "direct";
  static final String RELIABLE = "reliable";
  static final String TRANSIENT_LOCAL = "transient_local";

  private static final String NAME = "[A-Za-z_][A-Za-z0-9_]*";
  private static final String NAMESPACE_PATTERN = "^(/|(/" + NAME + ")+)$";

  /** Words that YAML takes for no text. */
  private static final String NO_TEXT = "true|false|yes|no|on|off|y|n";

  private static final String HOST_PATTERN =
      "^(?!(" + NO_TEXT + ")$)(" + Form.HOST + "|[0-9a-fA-F:.]*:[0-9a-fA-F:.]*)$";

  private static final String TOPIC_PATTERN =
      "^(?!(" + NO_TEXT + ")$)/?" + NAME + "(/" + NAME + ")*$";

  private static final String FRAME_PATTERN =
      "^(?!(" + NO_TEXT + "|(.*/)?(odom|base_link|base_footprint))$)[A-Za-z_/][A-Za-z0-9_/.-]*$";

  private static final int HOUR_MS = 3_600_000;

  static final Field<String> RELIABILITY =
      Field.choice(
              "reliability",
              "the subscription's; best_effort receives from every publisher",
              RELIABLE,
              "best_effort")
          .defaultsTo("best_effort");
  static final Field<String> COMMAND_RELIABILITY =
      Field.choice(
              "reliability",
              "the publisher's; bases subscribe with reliable, and receive nothing from best_effort",
              RELIABLE,
              "best_effort")
          .defaultsTo(RELIABLE);
  static final Field<String> DURABILITY =
      Field.choice(
              "durability",
              "volatile, unless the base asks for transient_local",
              "volatile",
              TRANSIENT_LOCAL)
          .defaultsTo("volatile");

  static final Field<String> APP =
      Field.text(
          "app",
          "an app of 'starl list'",
          "the app that every robot runs; if it is missing, it is chosen on each phone, and no"
              + " board can run it");
  static final Field<Void> PARAMETERS =
      Field.mapping(
          "parameters",
          new Form.Parameters("lines such as 'scenario: figure7'"),
          "parameters of the app, and settings, as in a scenario file; the same for all robots");
  static final Field<Long> SEED =
      Field.wholeLong("seed", "seed of the scenario and of the robots' random choices")
          .defaultsTo("0");
  static final Field<String> KEY =
      Field.text(
          "key",
          "the path of a key, as 'starl keygen' makes it",
          "file of one key for all robots, as 'starl keygen' makes it; relative to this file's folder;"
              + " without it and without the robots' public keys, datagrams are not sealed and"
              + " broadcasts must be off");

  static final Field<Integer> RADIO_PORT =
      port("UDP port of the broadcast beacons, and of each robot whose address has no port")
          .defaultsTo("4747");
  static final Field<Boolean> BROADCASTS =
      Field.yesNo(
              "broadcasts",
              "whether beacons are broadcast on every interface, so that robots without an address are"
                  + " found")
          .defaultsTo("yes");
  static final Field<Integer> BEACON_EVERY_MS =
      Field.whole("beaconEveryMs", 50, HOUR_MS / 2, "time between two beacons of a robot, in ms")
          .defaultsTo("1000");
  static final Field<Integer> SUSPECT_AFTER_MS =
      Field.whole(
              "suspectAfterMs",
              100,
              HOUR_MS,
              "a robot that was not heard for this time, in ms, is suspected; at least twice"
                  + " beaconEveryMs")
          .defaultsTo("3000");
  static final Field<Double> LOSS =
      Field.decimal(
              "loss",
              0,
              1,
              "fraction, from 0 to 1, of its own datagrams that each robot drops on purpose")
          .defaultsTo("0");
  static final Field<Void> NETWORK =
      Field.mapping(
          "network",
          new Lines(
              "lines such as 'port: 4747'",
              List.of(RADIO_PORT, BROADCASTS, BEACON_EVERY_MS, SUSPECT_AFTER_MS, LOSS)),
          "how the robots find and hear each other");

  static final Field<String> SOURCE =
      Field.choice(
              "source",
              "natnet for OptiTrack, json for lines of JSON over UDP, ros2 for topics of ROS 2",
              NATNET,
              JSON,
              ROS2)
          .needed();
  static final Field<HostPort> SERVER =
      Field.of(
              "server",
              new Address(false),
              "HOST or HOST:PORT of the NatNet server's commands; port 1510 if it has none",
              text -> HostPort.parse(text, DeploymentReader.COMMAND_PORT))
          .needed();
  static final Field<Integer> DATA_PORT =
      Field.whole("dataPort", 1, HostPort.MAX_PORT, "UDP port of frames that come by multicast")
          .defaultsTo("1511");
  static final Field<String> MULTICAST =
      Field.matching(
          "multicast",
          "a group from 224.0.0.0 to 239.255.255.255, such as 239.255.42.99",
          "^(22[4-9]|23\\d)(\\." + Form.OCTET + "){3}$",
          "address of the group to which frames are sent; without it the server sends to each robot");
  static final Field<String> INTERFACE =
      Field.text(
          "interface",
          "the name or the address of a network interface, such as wlan0",
          "the network interface, on each robot, to which the cameras' frames come; without it the one"
              + " that reaches the server");
  static final Field<String> VERSION =
      Field.choice(
              "version",
              "version of NatNet that the simulated server speaks; a client takes the server's",
              "3.1",
              "4.0",
              "4.1",
              "4.2")
          .defaultsTo("4.1");
  static final Field<String> UP =
      Field.choice("up", "the axis that points up in Motive's stream", "y", "z").defaultsTo("y");
  static final Field<Double> ERROR_MM =
      Field.decimal("errorMm", 0, 1000, "largest error of a measured position, in mm")
          .defaultsTo("5");
  static final Field<Double> ERROR_RAD =
      Field.decimal("errorRad", 0, 3, "largest error of a measured heading, in rad")
          .defaultsTo("0.02");
  static final Field<Integer> JSON_PORT =
      port("UDP port at which each robot receives the lines").defaultsTo("1520");
  static final Field<String> LISTEN =
      Field.matching(
          "listen",
          "an address such as 127.0.0.1",
          HOST_PATTERN,
          "the address, on each robot, at which it receives the lines; without it that of its radio,"
              + " or all interfaces if it has none");
  static final Field<String> LINES_KEY =
      Field.text(
          "key",
          "the path of a key, as 'starl keygen' makes it",
          "file of the key that authenticates the lines, relative to this file's folder; without it"
              + " any computer that sends from the sender's address can move the robots");
  static final Field<String> SENDER =
      Field.matching(
          "sender",
          "a host whose lines are taken",
          HOST_PATTERN,
          "the only host whose lines are taken; without it, every host's are");
  static final Field<String> POSE_TOPIC =
      Field.matching(
              "topic",
              "a topic such as /{robot}/pose, with {robot} in it",
              "^/.*\\{robot\\}.*$",
              "the topic of each robot's pose; {robot} stands for the robot's rigidBody")
          .defaultsTo("/{robot}/pose");
  static final Field<String> POSE_TYPE =
      Field.choice(
              "type",
              "the messages' type: of geometry_msgs, or nav_msgs/Odometry in a frame that does not"
                  + " drift",
              "PoseStamped",
              "PoseWithCovarianceStamped",
              "Odometry")
          .defaultsTo("PoseStamped");
  static final Field<String> FRAME =
      Field.matching(
              "frame",
              "a frame that does not drift, such as map",
              FRAME_PATTERN,
              "the frame of the poses; messages of other frames are dropped, and frames that drift"
                  + " (odom, base_link) are refused")
          .defaultsTo("map");
  static final Field<Double> SIGMAS =
      Field.decimal(
              "sigmas",
              1,
              10,
              "standard deviations of a message's covariance that bound its error; errorMm and"
                  + " errorRad are the least bounds")
          .defaultsTo("3");
  static final Field<Void> POSITIONS =
      Field.mapping(
              "positions",
              new Kinds(
                  "lines such as 'source: natnet'",
                  SOURCE,
                  kinds(
                      NATNET,
                      List.of(
                          SERVER, DATA_PORT, MULTICAST, INTERFACE, VERSION, UP, ERROR_MM,
                          ERROR_RAD),
                      JSON,
                      List.of(JSON_PORT, LISTEN, SENDER, LINES_KEY, ERROR_MM, ERROR_RAD),
                      ROS2,
                      List.of(
                          POSE_TOPIC,
                          POSE_TYPE,
                          FRAME,
                          SIGMAS,
                          RELIABILITY,
                          DURABILITY,
                          ERROR_MM,
                          ERROR_RAD))),
              "the system that measures the robots' positions")
          .needed();

  static final Field<HostPort> WORLD =
      Field.of(
          "world",
          new Address(true),
          "HOST:PORT of the process that simulates bodies; needed if some robots are simulated",
          text -> HostPort.parse(text, 0));

  /** Its port may depend on the network's: only checked here. */
  static final Field<String> ADDRESS =
      Field.of(
          "address",
          new Address(false),
          "HOST or HOST:PORT of the robot's radio; without it the robot is found by its beacons",
          text -> HostPort.parse(text, HostPort.MAX_PORT) == null ? null : text);

  static final Field<String> RIGID_BODY =
      Field.text(
          "rigidBody",
          "the rigid body's name",
          "the robot's name in the measuring system; without it, the name used here");
  static final Field<List<PublicRobotKey>> PUBLIC_KEY =
      Field.of(
          "publicKey",
          new Form.Words(
              "a key that 'starl keygen --robot' has printed, or two with a space between",
              PublicRobotKey.PATTERN),
          "the robot's public key, as 'starl keygen --robot NAME' prints it; while a key is replaced,"
              + " the new and the old one, with a space between; its secret half is in NAME.key in this"
              + " file's folder, on that robot only",
          PublicRobotKey::parseOrNull);
  static final Field<String> KIND =
      Field.choice(
              "kind",
              "create for an iRobot Create, simulated for a body in the world's process",
              CREATE,
              SIMULATED)
          .needed();
  static final Field<String> MODEL =
      Field.choice(
              "model",
              "which Create: create1, or create2 for a Create 2 and Roombas of the 500 and 600 series",
              "create1",
              "create2")
          .defaultsTo("create2");
  static final Field<Wheels.Port> PORT =
      Field.of(
              "port",
              new Form.Port(),
              "the Create's serial line: a device such as /dev/ttyUSB0, or tcp:HOST:PORT",
              Wheels.Port::parse)
          .needed();
  static final Field<Integer> BAUD =
      Field.whole(
          "baud",
          300,
          3_000_000,
          "bits a second on a device; without it 57600 for create1 and 115200 for create2");
  static final Field<Wheels.Port> SIMULATED_AT =
      Field.of(
          "simulatedAt",
          new Form.Port(),
          "where the world's process simulates the Create: a pseudo terminal of that name, or"
              + " tcp:HOST:PORT where it listens; without it the Create is real",
          Wheels.Port::parse);
  static final Field<Void> CHASSIS =
      Field.mapping(
              "chassis",
              new Kinds(
                  "lines such as 'kind: create'",
                  KIND,
                  kinds(CREATE, List.of(MODEL, PORT, BAUD, SIMULATED_AT), SIMULATED, List.of())),
              "the robot's drive")
          .needed();
  static final Field<String> PLATFORM =
      Field.choice(
              "platform",
              "direct if StarL drives the wheels itself, ros2 if the base is a ROS 2 node",
              DIRECT,
              ROS2)
          .defaultsTo(DIRECT);
  static final Field<String> NAMESPACE =
      Field.matching(
          "namespace",
          "a namespace such as /bot0",
          NAMESPACE_PATTERN,
          "of the base's topics; without it a slash and the robot's name");
  static final Field<Double> AXLE_MM =
      Field.decimal(
              "axleMm",
              10,
              2000,
              "distance between the wheels, in mm, for the limit of their speeds; 233 is a Create 3's")
          .defaultsTo("233");
  static final Field<String> COMMAND_NAME = topic("cmd_vel");
  static final Field<String> COMMAND_TYPE =
      Field.choice("type", "the messages' type, of geometry_msgs", "Twist", "TwistStamped")
          .defaultsTo("Twist");
  static final Field<String> ODOMETRY_NAME = topic("odom");
  static final Field<String> CONTACTS_NAME = topic("hazard_detection");
  static final Field<String> CONTACTS_TYPE =
      Field.choice(
              "type",
              "HazardDetectionVector of a Create 3, Bool (true: touches something), or LaserScan",
              "HazardDetectionVector",
              "Bool",
              "LaserScan")
          .defaultsTo("HazardDetectionVector");
  static final Field<Double> NEAR_MM =
      Field.decimal(
              "nearMm",
              1,
              10_000,
              "a LaserScan with a range below this, in mm, is a contact on that side of the front")
          .defaultsTo("200");
  static final Field<Void> COMMAND =
      Field.mapping(
          "command",
          new Lines(
              "lines such as 'name: cmd_vel'",
              List.of(COMMAND_NAME, COMMAND_TYPE, COMMAND_RELIABILITY, DURABILITY)),
          "the topic of the base's speeds");
  static final Field<Void> ODOMETRY =
      Field.mapping(
          "odometry",
          new Lines("lines such as 'name: odom'", List.of(ODOMETRY_NAME, RELIABILITY, DURABILITY)),
          "the topic of the base's nav_msgs/Odometry; it is no position, because its frame drifts");
  static final Field<Void> CONTACTS =
      Field.mapping(
          "contacts",
          new Lines(
              "lines such as 'type: Bool'",
              List.of(CONTACTS_NAME, CONTACTS_TYPE, NEAR_MM, RELIABILITY, DURABILITY)),
          "the topic of the base's contacts; without it none are known");
  static final Field<Void> TOPICS =
      Field.mapping(
          "topics",
          new Lines("lines such as 'command:'", List.of(COMMAND, ODOMETRY, CONTACTS)),
          "the base's topics, where they differ from the usual ones");
  static final Field<String> OBJECTS =
      Field.choice(
          "objects",
          "the robot's sensor for objects that are no robots: positions for tagged bodies in the"
              + " position feed, which must see them, or bumper for what is at the Create's bumper;"
              + " without it, apps that need one are refused",
          "positions",
          "bumper");
  static final Kinds ROBOT =
      new Kinds(
          "lines such as 'address: 192.168.1.10'",
          PLATFORM,
          kinds(
              DIRECT,
              List.of(ADDRESS, RIGID_BODY, PUBLIC_KEY, CHASSIS, OBJECTS),
              ROS2,
              List.of(ADDRESS, RIGID_BODY, PUBLIC_KEY, NAMESPACE, AXLE_MM, TOPICS, OBJECTS)));
  static final Field<Void> ROBOTS =
      Field.mapping(
              "robots",
              new Form.Named("a robot's name, and beneath it its address and chassis", ROBOT),
              "the robots, by the names that the app's scenario gives them")
          .needed();

  static final Field<Double> SPEED_MM_PER_S =
      Field.decimal("speedMmPerS", 1, 500, "greatest speed of a wheel, in mm/s").defaultsTo("500");
  static final Field<Integer> WATCHDOG_MS =
      Field.whole(
              "watchdogMs",
              20,
              10_000,
              "the wheels stop if the program gives no command for this time, in ms")
          .defaultsTo("300");
  static final Field<Integer> POSITION_MS =
      Field.whole("positionMs", 20, 60_000, "the wheels stop this time after the last fix, in ms")
          .defaultsTo("500");
  static final Field<Double> SPEED_ERROR =
      Field.decimal(
              "speedError",
              0,
              0.9,
              "fraction by which the wheels may be faster than commanded; they may be slower by any"
                  + " amount")
          .defaultsTo("0.1");
  static final Field<Integer> REACTION_MS =
      Field.whole(
              "reactionMs",
              0,
              2000,
              "time, in ms, until a command is in effect and the old speed braked down; it includes the"
                  + " strand, the link, the robot's own period and braking")
          .defaultsTo("200");
  static final Field<Void> LIMITS =
      Field.mapping(
          "limits",
          new Lines(
              "lines such as 'watchdogMs: 200'",
              List.of(SPEED_MM_PER_S, WATCHDOG_MS, POSITION_MS, SPEED_ERROR, REACTION_MS)),
          "limits of the wheels, enforced below the program, and the errors that the program expects");

  /** The whole file. */
  public static final Lines FILE =
      new Lines(
          "lines such as 'app: intersection'",
          List.of(APP, PARAMETERS, SEED, KEY, NETWORK, POSITIONS, WORLD, ROBOTS, LIMITS));

  private DeploymentFormat() {}

  private static Field<Integer> port(String meaning) {
    return Field.whole("port", 1, HostPort.MAX_PORT, meaning);
  }

  private static Field<String> topic(String usual) {
    return Field.matching(
            "name",
            "a topic such as " + usual,
            TOPIC_PATTERN,
            "the topic, in the robot's namespace unless it begins with a slash")
        .defaultsTo(usual);
  }

  private static Map<String, List<Field<?>>> kinds(
      String first,
      List<Field<?>> ofFirst,
      String second,
      List<Field<?>> ofSecond,
      String third,
      List<Field<?>> ofThird) {
    Map<String, List<Field<?>>> kinds = kinds(first, ofFirst, second, ofSecond);
    kinds.put(third, ofThird);
    return kinds;
  }

  private static Map<String, List<Field<?>>> kinds(
      String first, List<Field<?>> ofFirst, String second, List<Field<?>> ofSecond) {
    Map<String, List<Field<?>>> kinds = new LinkedHashMap<>();
    kinds.put(first, ofFirst);
    kinds.put(second, ofSecond);
    return kinds;
  }
}
