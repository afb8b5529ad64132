package org.starl.robot.file;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.input.DocumentReader;
import org.starl.input.Field;
import org.starl.input.Section;
import org.starl.robot.file.Wheels.Create;
import org.starl.robot.udp.PublicRobotKey;

/** Makes a {@link Deployment} of a file's text. */
public final class DeploymentReader {

  /** What a file contains, for messages. */
  public static final String EXPECTED = "expected " + DeploymentFormat.FILE.expected();

  static final int COMMAND_PORT = 1510;
  private static final int CREATE1_BAUD = 57_600;
  private static final int CREATE2_BAUD = 115_200;

  private final String file;
  private final Section top;

  private DeploymentReader(String file, Section top) {
    this.file = file;
    this.top = top;
  }

  /**
   * The deployment in {@code text}.
   *
   * @param file its name, for messages
   * @throws BadInput if the text is no YAML, or a part is missing, unknown, out of its range, or
   *     contradicts another
   */
  public static Deployment read(String file, String text) {
    Section top = Section.of(file, DocumentReader.read(file, text, EXPECTED));
    return new DeploymentReader(file, top).deployment();
  }

  private Deployment deployment() {
    Map<String, Integer> lines = new LinkedHashMap<>();
    for (Field<?> field :
        List.of(
            DeploymentFormat.APP,
            DeploymentFormat.KEY,
            DeploymentFormat.POSITIONS,
            DeploymentFormat.WORLD,
            DeploymentFormat.LIMITS)) {
      lines.put(field.key(), top.line(field.key()));
    }
    String app = top.getOrNull(DeploymentFormat.APP);
    String key = top.getOrNull(DeploymentFormat.KEY);
    long seed = top.get(DeploymentFormat.SEED);
    Map<String, String> parameters = parameters(lines);
    Network network = network();
    Positions positions = positions();
    Limits limits = limits();
    HostPort world = top.getOrNull(DeploymentFormat.WORLD);
    SortedMap<RobotId, RobotEntry> robots = robots(network);
    top.end();
    Deployment deployment =
        new Deployment(
            file,
            app == null ? "" : app,
            seed,
            parameters,
            lines,
            key,
            network,
            positions,
            robots,
            world,
            limits);
    refuseContradictions(deployment);
    return deployment;
  }

  private Map<String, String> parameters(Map<String, Integer> lines) {
    Map<String, String> parameters = new LinkedHashMap<>();
    Section given = top.section(DeploymentFormat.PARAMETERS);
    for (String name : given.keys()) {
      parameters.put(name, given.get(Field.text(name, "one value", "").needed()));
      lines.put(name, given.line(name));
    }
    return parameters;
  }

  private Network network() {
    Section given = top.section(DeploymentFormat.NETWORK);
    Network network =
        new Network(
            given.get(DeploymentFormat.RADIO_PORT),
            given.get(DeploymentFormat.BROADCASTS),
            given.get(DeploymentFormat.BEACON_EVERY_MS),
            given.get(DeploymentFormat.SUSPECT_AFTER_MS),
            given.get(DeploymentFormat.LOSS));
    given.end();
    if (network.suspectAfterMs() < 2 * network.beaconEveryMs()) {
      throw given.wrong(
          DeploymentFormat.SUSPECT_AFTER_MS.key(),
          Integer.toString(network.suspectAfterMs()),
          "at least twice beaconEveryMs, which is " + network.beaconEveryMs());
    }
    return network;
  }

  private Positions positions() {
    Section given = top.section(DeploymentFormat.POSITIONS);
    String source = given.get(DeploymentFormat.SOURCE);
    Positions positions =
        source.equals(DeploymentFormat.ROS2)
            ? rosPositions(given)
            : source.equals(DeploymentFormat.NATNET)
                ? new Positions.NatNet(
                    given.get(DeploymentFormat.SERVER),
                    given.get(DeploymentFormat.DATA_PORT),
                    given.getOrNull(DeploymentFormat.MULTICAST),
                    given.getOrNull(DeploymentFormat.INTERFACE),
                    given.get(DeploymentFormat.VERSION),
                    given.get(DeploymentFormat.UP).equals("y"),
                    given.get(DeploymentFormat.ERROR_MM),
                    given.get(DeploymentFormat.ERROR_RAD))
                : new Positions.JsonFeed(
                    given.get(DeploymentFormat.JSON_PORT),
                    given.getOrNull(DeploymentFormat.LISTEN),
                    given.getOrNull(DeploymentFormat.SENDER),
                    given.getOrNull(DeploymentFormat.LINES_KEY),
                    given.get(DeploymentFormat.ERROR_MM),
                    given.get(DeploymentFormat.ERROR_RAD));
    given.end();
    return positions;
  }

  private static Positions rosPositions(Section given) {
    RosTopic topic =
        topic(
            "positions",
            given,
            "/",
            given.get(DeploymentFormat.POSE_TOPIC),
            given.get(DeploymentFormat.POSE_TYPE),
            DeploymentFormat.RELIABILITY);
    return new Positions.Ros2(
        topic,
        given.get(DeploymentFormat.FRAME),
        given.get(DeploymentFormat.SIGMAS),
        given.get(DeploymentFormat.ERROR_MM),
        given.get(DeploymentFormat.ERROR_RAD));
  }

  private Limits limits() {
    Section given = top.section(DeploymentFormat.LIMITS);
    Limits limits =
        new Limits(
            given.get(DeploymentFormat.SPEED_MM_PER_S),
            given.get(DeploymentFormat.WATCHDOG_MS),
            given.get(DeploymentFormat.POSITION_MS),
            given.get(DeploymentFormat.SPEED_ERROR),
            given.get(DeploymentFormat.REACTION_MS));
    given.end();
    return limits;
  }

  private SortedMap<RobotId, RobotEntry> robots(Network network) {
    Section given = top.section(DeploymentFormat.ROBOTS);
    SortedMap<RobotId, RobotEntry> robots = new TreeMap<>();
    for (String name : given.keys()) {
      if (!RobotId.isValid(name)) {
        throw given.wrong(name, name, "a name: " + RobotId.FORM);
      }
      Section robot = given.section(Field.mapping(name, DeploymentFormat.ROBOT, ""));
      RobotId id = new RobotId(name);
      String address = robot.getOrNull(DeploymentFormat.ADDRESS);
      String rigidBody = robot.getOrNull(DeploymentFormat.RIGID_BODY);
      List<PublicRobotKey> publicKeys = robot.getOrNull(DeploymentFormat.PUBLIC_KEY);
      robots.put(
          id,
          new RobotEntry(
              id,
              given.line(name),
              address == null ? null : HostPort.parse(address, network.port()),
              robot.get(DeploymentFormat.PLATFORM).equals(DeploymentFormat.ROS2)
                  ? ros2(robot, name)
                  : wheels(robot),
              rigidBody == null ? name : rigidBody,
              publicKeys == null ? List.of() : publicKeys,
              objects(robot)));
      robot.end();
    }
    if (robots.isEmpty()) {
      throw top.wrong(DeploymentFormat.ROBOTS.key(), "", "at least one robot");
    }
    return robots;
  }

  private static @Nullable ObjectSource objects(Section robot) {
    String source = robot.getOrNull(DeploymentFormat.OBJECTS);
    return source == null ? null : ObjectSource.valueOf(source.toUpperCase(Locale.ROOT));
  }

  private static Wheels wheels(Section robot) {
    Section given = robot.section(DeploymentFormat.CHASSIS);
    boolean isSimulated = given.get(DeploymentFormat.KIND).equals(DeploymentFormat.SIMULATED);
    Wheels wheels = isSimulated ? new Wheels.Simulated() : create(given);
    given.end();
    return wheels;
  }

  private static Wheels ros2(Section robot, String name) {
    String given = robot.getOrNull(DeploymentFormat.NAMESPACE);
    String namespace = given == null ? "/" + name : given;
    String path = "robots." + name + ".topics.";
    double axleMm = robot.get(DeploymentFormat.AXLE_MM);
    Section topics = robot.section(DeploymentFormat.TOPICS);
    boolean hasContacts = topics.keys().contains(DeploymentFormat.CONTACTS.key());
    Section command = topics.section(DeploymentFormat.COMMAND);
    Section odometry = topics.section(DeploymentFormat.ODOMETRY);
    Section contacts = topics.section(DeploymentFormat.CONTACTS);
    topics.end();
    Wheels.Ros2 wheels =
        new Wheels.Ros2(
            namespace,
            axleMm,
            topic(
                path + DeploymentFormat.COMMAND.key(),
                command,
                namespace,
                command.get(DeploymentFormat.COMMAND_NAME),
                command.get(DeploymentFormat.COMMAND_TYPE),
                DeploymentFormat.COMMAND_RELIABILITY),
            topic(
                path + DeploymentFormat.ODOMETRY.key(),
                odometry,
                namespace,
                odometry.get(DeploymentFormat.ODOMETRY_NAME),
                "Odometry",
                DeploymentFormat.RELIABILITY),
            hasContacts
                ? topic(
                    path + DeploymentFormat.CONTACTS.key(),
                    contacts,
                    namespace,
                    contacts.get(DeploymentFormat.CONTACTS_NAME),
                    contacts.get(DeploymentFormat.CONTACTS_TYPE),
                    DeploymentFormat.RELIABILITY)
                : null,
            contacts.get(DeploymentFormat.NEAR_MM));
    command.end();
    odometry.end();
    contacts.end();
    return wheels;
  }

  private static RosTopic topic(
      String key,
      Section given,
      String namespace,
      String name,
      String type,
      Field<String> reliability) {
    String absolute =
        name.startsWith("/") ? name : namespace + (namespace.endsWith("/") ? "" : "/") + name;
    return new RosTopic(
        key,
        absolute,
        type,
        given.get(reliability).equals(DeploymentFormat.RELIABLE),
        given.get(DeploymentFormat.DURABILITY).equals(DeploymentFormat.TRANSIENT_LOCAL));
  }

  private static Wheels create(Section given) {
    String model = given.get(DeploymentFormat.MODEL);
    Integer baud = given.getOrNull(DeploymentFormat.BAUD);
    int usualBaud = model.equals("create1") ? CREATE1_BAUD : CREATE2_BAUD;
    return new Create(
        model,
        given.get(DeploymentFormat.PORT),
        baud == null ? usualBaud : baud,
        given.getOrNull(DeploymentFormat.SIMULATED_AT));
  }

  private void refuseContradictions(Deployment deployment) {
    Map<String, RobotEntry> addresses = new LinkedHashMap<>();
    Map<String, RobotEntry> ports = new LinkedHashMap<>();
    Map<String, RobotEntry> bodies = new LinkedHashMap<>();
    for (RobotEntry robot : deployment.robots().values()) {
      if (robot.address() != null) {
        refuseShared(addresses, "address", robot.address().toString(), robot);
      } else if (!deployment.network().broadcasts()) {
        throw at(robot, "has no address, and network.broadcasts is off; expected one of the two");
      }
      if (robot.wheels() instanceof Create create) {
        // Two machines may each have a device of one name.
        String machine =
            create.port() instanceof Wheels.Tcp
                ? ""
                : robot.address() == null ? " of " + robot.id() : " of " + robot.address().host();
        refuseShared(ports, "chassis.port", create.port() + machine, robot);
      }
      if (robot.wheels() instanceof Wheels.Ros2 ros2) {
        refuseShared(ports, "topics.command", ros2.command().name(), robot);
      }
      refuseShared(bodies, "rigidBody", robot.rigidBody(), robot);
      refuseSimulation(deployment, robot);
    }
    refuseKeys(deployment);
  }

  private void refuseKeys(Deployment deployment) {
    boolean areSeparate = deployment.hasSeparateKeys();
    for (RobotEntry robot : deployment.robots().values()) {
      if (areSeparate && robot.publicKeys().isEmpty()) {
        throw at(robot, "has no publicKey, and another robot has one; expected one for each");
      }
    }
    if (areSeparate && deployment.key() != null) {
      throw top.wrong(
          DeploymentFormat.KEY.key(),
          deployment.key(),
          "no key for all, since each robot has its own");
    }
    if (!areSeparate && deployment.key() == null && deployment.network().broadcasts()) {
      throw top.missing(
          DeploymentFormat.KEY.key(),
          "the path of a key, or publicKey for each robot, or network.broadcasts: no: without keys,"
              + " unknown robots could join");
    }
  }

  private void refuseSimulation(Deployment deployment, RobotEntry robot) {
    boolean isSimulated = deployment.simulated().contains(robot);
    if (isSimulated && deployment.world() == null) {
      throw at(robot, "is simulated; expected 'world: HOST:PORT', where its body is");
    }
    if (isSimulated && deployment.positions() instanceof Positions.Ros2) {
      throw at(robot, "is simulated; expected positions.source natnet or json: no world has ROS 2");
    }
    if (isSimulated
        && robot.address() == null
        && deployment.positions() instanceof Positions.JsonFeed) {
      throw at(robot, "is simulated; expected an address, to which its world sends positions");
    }
  }

  private void refuseShared(
      Map<String, RobotEntry> taken, String key, String value, RobotEntry robot) {
    RobotEntry other = taken.put(value, robot);
    if (other != null) {
      throw at(
          robot, key + ": '" + value + "': expected a value that " + other.id() + " does not have");
    }
  }

  private BadInput at(RobotEntry robot, String text) {
    return BadInput.at(file, robot.line(), "robots." + robot.id() + ": " + text);
  }
}
