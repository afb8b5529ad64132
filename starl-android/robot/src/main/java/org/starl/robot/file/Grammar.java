package org.starl.robot.file;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.starl.robot.file.Form.Address;
import org.starl.robot.file.Form.Amount;
import org.starl.robot.file.Form.Choice;
import org.starl.robot.file.Form.Kinds;
import org.starl.robot.file.Form.Lines;
import org.starl.robot.file.Form.Named;
import org.starl.robot.file.Form.Parameters;
import org.starl.robot.file.Form.Text;
import org.starl.robot.file.Form.Whole;
import org.starl.robot.file.Form.YesNo;

/**
 * Every line that a deployment file can have: {@link DeploymentReader} reads these and no others, and
 * the schema for editors is drawn from them.
 */
public final class Grammar {

  static final String NATNET = "natnet";
  static final String JSON = "json";
  static final String CREATE = "create";
  static final String SIMULATED = "simulated";

  private static final int HOUR_MS = 3_600_000;

  static final Field APP =
      Field.needed("app", new Text("an app of 'starl list'"), "the app that every robot runs");
  static final Field PARAMETERS =
      Field.optional(
          "parameters",
          new Parameters("lines such as 'scenario: figure7'"),
          "parameters of the app, and settings, as in a scenario file; the same for all robots");
  static final Field SEED =
      Field.usually(
          "0",
          "seed",
          new Whole(Long.MIN_VALUE, Long.MAX_VALUE),
          "draws the scenario, and what robots draw");
  static final Field KEY =
      Field.optional(
          "key",
          new Text("the path of a key, as 'starl keygen' makes it"),
          "file of the deployment's key, looked up beside this one, as 'starl keygen' makes it; without"
              + " one datagrams are not sealed, and broadcasts must be off");

  static final Field RADIO_PORT =
      Field.usually(
          "4747",
          "port",
          new Whole(1, HostPort.MAX_PORT),
          "UDP port of each robot whose address names none, and of the broadcast beacons");
  static final Field BROADCASTS =
      Field.usually(
          "yes",
          "broadcasts",
          new YesNo(),
          "whether beacons are broadcast on every interface, so that robots without an address are found");
  static final Field BEACON_EVERY_MS =
      Field.usually(
          "1000",
          "beaconEveryMs",
          new Whole(50, HOUR_MS / 2),
          "so often, in ms, a robot says that it is there");
  static final Field SUSPECT_AFTER_MS =
      Field.usually(
          "3000",
          "suspectAfterMs",
          new Whole(100, HOUR_MS),
          "who was not heard for so long, in ms, is suspected; at least twice beaconEveryMs");
  static final Field LOSS =
      Field.usually(
          "0",
          "loss",
          new Amount(0, 1),
          "share, from 0 to 1, of its own datagrams that each robot loses on purpose");
  static final Field NETWORK =
      Field.optional(
          "network",
          new Lines(
              "lines such as 'port: 4747'",
              List.of(RADIO_PORT, BROADCASTS, BEACON_EVERY_MS, SUSPECT_AFTER_MS, LOSS)),
          "how the robots find and hear each other");

  static final Field SOURCE =
      Field.needed(
          "source",
          Choice.of(NATNET, JSON),
          "who measures: natnet for OptiTrack, json for lines of JSON over UDP");
  static final Field SERVER =
      Field.needed(
          "server",
          new Address(false),
          "HOST or HOST:PORT at which the NatNet server takes commands; port 1510 unless given");
  static final Field DATA_PORT =
      Field.usually(
          "1511",
          "dataPort",
          new Whole(1, HostPort.MAX_PORT),
          "UDP port at which frames come, where they come by multicast");
  static final Field MULTICAST =
      Field.optional(
          "multicast",
          new Text("a group such as 239.255.42.99"),
          "address of the group to which frames are sent; without it the server sends to each robot");
  static final Field VERSION =
      Field.usually(
          "4.1",
          "version",
          Choice.of("3.1", "4.0", "4.1", "4.2"),
          "version of NatNet that the simulated server speaks; a client takes the server's");
  static final Field UP =
      Field.usually("y", "up", Choice.of("y", "z"), "the axis that points up in Motive's stream");
  static final Field ERROR_MM =
      Field.usually(
          "5",
          "errorMm",
          new Amount(0, 1000),
          "a measured position is off by so much, in mm, at most");
  static final Field ERROR_RAD =
      Field.usually(
          "0.02",
          "errorRad",
          new Amount(0, 3),
          "a measured heading is off by so much, in rad, at most");
  static final Field JSON_PORT =
      Field.usually(
          "1520",
          "port",
          new Whole(1, HostPort.MAX_PORT),
          "UDP port at which each robot hears the lines");
  static final Field SENDER =
      Field.optional(
          "sender",
          new Text("a host whose lines are taken"),
          "host whose lines alone are taken; without it, anybody's");
  static final Field POSITIONS =
      Field.needed(
          "positions",
          new Kinds(
              "lines such as 'source: natnet'",
              SOURCE,
              kinds(
                  NATNET,
                  List.of(SERVER, DATA_PORT, MULTICAST, VERSION, UP, ERROR_MM, ERROR_RAD),
                  JSON,
                  List.of(JSON_PORT, SENDER, ERROR_MM, ERROR_RAD))),
          "who measures where the robots are");

  static final Field WORLD =
      Field.optional(
          "world",
          new Address(true),
          "HOST:PORT of the process in which bodies are simulated; needed where some are");

  static final Field ADDRESS =
      Field.optional(
          "address",
          new Address(false),
          "HOST or HOST:PORT of the robot's radio; without it the robot is found by its beacons");
  static final Field RIGID_BODY =
      Field.optional(
          "rigidBody",
          new Text("the rigid body's name"),
          "what the measuring system calls the robot; its own name unless given");
  static final Field KIND =
      Field.needed(
          "kind",
          Choice.of(CREATE, SIMULATED),
          "create for an iRobot Create, simulated for a body in the world's process");
  static final Field MODEL =
      Field.usually(
          "create2",
          "model",
          Choice.of("create1", "create2"),
          "which Create: create1, or create2 for a Create 2 and Roombas of the 500 and 600 series");
  static final Field PORT =
      Field.needed(
          "port",
          new Form.Port(),
          "where the Create's bytes come and go: a device such as /dev/ttyUSB0, or tcp:HOST:PORT");
  static final Field BAUD =
      Field.optional(
          "baud",
          new Whole(300, 3_000_000),
          "bits a second on a device; 57600 for create1 and 115200 for create2 unless given");
  static final Field SIMULATED_AT =
      Field.optional(
          "simulatedAt",
          new Form.Port(),
          "where the world's process simulates the Create: a pseudo terminal of that name, or"
              + " tcp:HOST:PORT where it listens; without it the Create is real");
  static final Field CHASSIS =
      Field.needed(
          "chassis",
          new Kinds(
              "lines such as 'kind: create'",
              KIND,
              kinds(CREATE, List.of(MODEL, PORT, BAUD, SIMULATED_AT), SIMULATED, List.of())),
          "what the robot drives on");
  static final Field ROBOTS =
      Field.needed(
          "robots",
          new Named(
              "a robot's name, and beneath it its address and chassis",
              new Lines(
                  "lines such as 'address: 192.168.1.10'", List.of(ADDRESS, RIGID_BODY, CHASSIS))),
          "the robots, by the names that the app's scenario gives them");

  static final Field SPEED_MM_PER_S =
      Field.usually(
          "500", "speedMmPerS", new Amount(1, 500), "no wheel turns faster than this, in mm/s");
  static final Field WATCHDOG_MS =
      Field.usually(
          "300",
          "watchdogMs",
          new Whole(20, 10_000),
          "a program that commands nothing for so long, in ms, has its wheels stopped");
  static final Field POSITION_MS =
      Field.usually(
          "500",
          "positionMs",
          new Whole(20, 60_000),
          "so long after the last fix, in ms, the wheels are stopped");
  static final Field SPEED_ERROR =
      Field.usually(
          "0.1",
          "speedError",
          new Amount(0, 0.9),
          "share by which the wheels may be faster than commanded; slower they may be at will");
  static final Field REACTION_MS =
      Field.usually(
          "200",
          "reactionMs",
          new Whole(0, 2000),
          "within so long, in ms, what the program commands is in effect, and the old speed braked"
              + " down: the strand, the link, the robot's own period and braking are in it");
  static final Field LIMITS =
      Field.optional(
          "limits",
          new Lines(
              "lines such as 'watchdogMs: 200'",
              List.of(SPEED_MM_PER_S, WATCHDOG_MS, POSITION_MS, SPEED_ERROR, REACTION_MS)),
          "what keeps the wheels in check, below the program, and what the program expects of them");

  /** The whole file. */
  public static final Lines FILE =
      new Lines(
          "lines such as 'app: intersection'",
          List.of(APP, PARAMETERS, SEED, KEY, NETWORK, POSITIONS, WORLD, ROBOTS, LIMITS));

  private Grammar() {}

  private static Map<String, List<Field>> kinds(
      String first, List<Field> ofFirst, String second, List<Field> ofSecond) {
    Map<String, List<Field>> kinds = new LinkedHashMap<>();
    kinds.put(first, ofFirst);
    kinds.put(second, ofSecond);
    return kinds;
  }
}
