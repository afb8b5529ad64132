package org.starl.robot.create;

import static org.starl.time.Time.NS_PER_MS;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.starl.robot.create.CreateBody.Sense;
import org.starl.robot.create.CreateBody.Senses;

/**
 * An iRobot Create, simulated at its serial line: commands in, sensor bytes out, a {@link CreateBody}
 * that it moves. It obeys the specification of its model: modes, the causes that end safe mode, streaming,
 * queries, both kinds of driving, lights, songs. Like a real one it continues its last command when
 * it receives nothing. Demonstrations only change its mode; the link sets the speed of the line;
 * scripts, schedules and displays are parsed and ignored.
 *
 * <p>Its wheels turn exactly as commanded; the body decides how the robot moves.
 *
 * <p>Without threads: {@link CreateHost} runs it in real time. The time of the calls never
 * decreases.
 */
public final class SimulatedCreate {

  /** Period of its sensors and of its stream. */
  public static final long PERIOD_NS = Packets.STREAM_PERIOD_MS * NS_PER_MS;

  /** Receives the bytes that the robot sends. */
  public interface Line {
    /** {@code bytes} belong to the line from now on. */
    void send(byte[] bytes);
  }

  private final CreateModel model;
  private final CreateBody body;
  private final Line line;
  private final CommandParser parser;
  private final CreateWheels wheels;
  private final CreateMusic music;
  private final int[] lights = new int[3];

  private OiMode mode = OiMode.OFF;
  private int @Nullable [] streamed;
  private boolean isPaused;
  private boolean isHeaderSummed = true;
  private long dueNs;
  private long nowNs;
  private Senses senses = Senses.NOTHING;
  private long refused;

  /** Creates a robot in mode OFF, standing. */
  public SimulatedCreate(CreateModel model, CreateBody body, Line line) {
    this.model = model;
    this.body = body;
    this.line = line;
    parser = new CommandParser(model);
    wheels = new CreateWheels(model);
    music = new CreateMusic(model);
  }

  /** Excludes the header from its checksums, as the Create 1 specification's example does. */
  public SimulatedCreate withoutHeaderInChecksums() {
    isHeaderSummed = false;
    return this;
  }

  /** Receives the first {@code length} of {@code bytes} at {@code atNs}. */
  public void receive(byte[] bytes, int length, long atNs) {
    advance(atNs);
    parser.accept(bytes, length, this::obey);
  }

  /** Advances to {@code atNs}: reads the sensors and streams. */
  public void advance(long atNs) {
    wheels.turnUntil(atNs);
    nowNs = atNs;
    if (atNs < dueNs) {
      return;
    }
    // After a delay it streams once, not once for each missed period.
    dueNs = Math.max(dueNs + PERIOD_NS, atNs - PERIOD_NS);
    senses = body.senses(atNs);
    keepSafe();
    int[] packets = streamed;
    if (packets != null && !isPaused && mode != OiMode.OFF) {
      line.send(frame(packets));
    }
  }

  /** The next time at which {@link #advance} has something to do. */
  public long dueNs() {
    return dueNs;
  }

  public OiMode mode() {
    return mode;
  }

  /** The rim's speed of the left wheel in mm/s. */
  public double leftMmPerS() {
    return wheels.leftMmPerS();
  }

  /** The rim's speed of the right wheel in mm/s. */
  public double rightMmPerS() {
    return wheels.rightMmPerS();
  }

  /** Bits, colour and intensity of the lights. */
  public int[] lights() {
    return lights.clone();
  }

  /** The song that is playing, -1 for none. */
  public int playing() {
    return music.playing(nowNs);
  }

  /** Commands that were not obeyed: in the wrong mode, or with invalid values. */
  public long refused() {
    return refused;
  }

  /** Bytes that began no command. */
  public long unknownBytes() {
    return parser.unknown();
  }

  private void obey(int opcode, byte[] data, int length) {
    if (opcode == Opcodes.START) {
      enter(OiMode.PASSIVE);
    } else if (mode == OiMode.OFF && opcode != Opcodes.RESET) {
      refused++;
    } else if (!changesMode(opcode) && !requestsSensors(opcode, data, length)) {
      act(opcode, data, length);
    }
  }

  private boolean changesMode(int opcode) {
    switch (opcode) {
      case Opcodes.CONTROL, Opcodes.SAFE -> enter(OiMode.SAFE);
      case Opcodes.FULL -> enter(OiMode.FULL);
      case Opcodes.POWER, Opcodes.SPOT, Opcodes.CLEAN, Opcodes.DEMO, Opcodes.DOCK ->
          enter(OiMode.PASSIVE);
      case Opcodes.STOP, Opcodes.RESET -> {
        enter(OiMode.OFF);
        streamed = null;
      }
      default -> {
        return false;
      }
    }
    return true;
  }

  private void enter(OiMode newMode) {
    boolean wasDriven = mode == OiMode.SAFE || mode == OiMode.FULL;
    boolean isDriven = newMode == OiMode.SAFE || newMode == OiMode.FULL;
    mode = newMode;
    if (isDriven && !wasDriven) {
      Arrays.fill(lights, 0);
    }
    if (!isDriven) {
      stopWheels();
    }
    keepSafe();
  }

  private boolean requestsSensors(int opcode, byte[] data, int length) {
    switch (opcode) {
      case Opcodes.SENSORS -> answer(data, 0, 1);
      case Opcodes.QUERY_LIST -> answer(data, 1, length);
      case Opcodes.STREAM -> stream(data, length);
      case Opcodes.PAUSE_RESUME -> isPaused = data[0] == 0;
      default -> {
        return false;
      }
    }
    return true;
  }

  private void act(int opcode, byte[] data, int length) {
    if (opcode == Opcodes.SONG) {
      refused += music.store(data, length) ? 0 : 1;
      return;
    }
    if (mode == OiMode.PASSIVE) {
      refused++;
      return;
    }
    switch (opcode) {
      case Opcodes.DRIVE -> wheels.drive(number(data, 0), number(data, 2));
      case Opcodes.DRIVE_DIRECT -> wheels.driveDirect(number(data, 0), number(data, 2));
      case Opcodes.DRIVE_PWM -> wheels.drivePwm(number(data, 0), number(data, 2));
      case Opcodes.PLAY -> refused += music.play(data[0] & 0xFF, nowNs) ? 0 : 1;
      case Opcodes.LEDS -> {
        for (int i = 0; i < lights.length; i++) {
          lights[i] = data[i] & 0xFF;
        }
      }
      default -> {
        return;
      }
    }
    keepSafe();
    body.drive(wheels.leftMmPerS(), wheels.rightMmPerS(), nowNs);
  }

  private void keepSafe() {
    boolean isInDanger =
        senses.has(Sense.DROP_LEFT)
            || senses.has(Sense.DROP_RIGHT)
            || (senses.has(Sense.CASTER_DROP) && model == CreateModel.CREATE_1)
            || senses.has(Sense.CHARGER)
            || (senses.anyCliff() && wheels.mayCrossACliff());
    if (mode == OiMode.SAFE && isInDanger) {
      mode = OiMode.PASSIVE;
      stopWheels();
    }
  }

  private void stopWheels() {
    wheels.stop();
    body.drive(0, 0, nowNs);
  }

  private void stream(byte[] data, int length) {
    int[] packets = new int[length - 1];
    int bytes = 0;
    for (int i = 0; i < packets.length; i++) {
      packets[i] = data[1 + i] & 0xFF;
      if (Packets.first(model, packets[i]) < 0) {
        refused++;
        return;
      }
      bytes += 1 + Packets.bytesOfAll(packets[i]);
    }
    // A real line would garble a longer frame.
    if (bytes + 3 > model.streamBytes()) {
      refused++;
      return;
    }
    streamed = packets.length == 0 ? null : packets;
    isPaused = false;
  }

  private byte[] frame(int[] packets) {
    int bytes = 0;
    for (int packet : packets) {
      bytes += 1 + Packets.bytesOfAll(packet);
    }
    byte[] frame = new byte[bytes + 3];
    frame[0] = Packets.FRAME_HEADER;
    frame[1] = (byte) bytes;
    int at = 2;
    for (int packet : packets) {
      frame[at] = (byte) packet;
      at = fill(frame, at + 1, packet);
    }
    int sum = isHeaderSummed ? 0 : -Packets.FRAME_HEADER;
    for (byte b : frame) {
      sum += b;
    }
    frame[at] = (byte) -sum;
    return frame;
  }

  private void answer(byte[] data, int from, int to) {
    int bytes = 0;
    for (int i = from; i < to; i++) {
      if (Packets.first(model, data[i] & 0xFF) < 0) {
        refused++;
        return;
      }
      bytes += Packets.bytesOfAll(data[i] & 0xFF);
    }
    byte[] answer = new byte[bytes];
    int at = 0;
    for (int i = from; i < to; i++) {
      at = fill(answer, at, data[i] & 0xFF);
    }
    line.send(answer);
  }

  private int fill(byte[] into, int from, int packet) {
    int at = from;
    for (int single = Packets.first(model, packet); single <= Packets.last(packet); single++) {
      int value = value(single);
      if (Packets.bytes(single) == 2) {
        into[at++] = (byte) (value >> 8);
      }
      into[at++] = (byte) value;
    }
    return at;
  }

  private int value(int packet) {
    return switch (packet) {
      case Packets.BUMPS_AND_DROPS -> bumpsAndDrops();
      case Packets.WALL -> bit(senses.has(Sense.WALL));
      case Packets.CLIFF_LEFT -> bit(senses.has(Sense.CLIFF_LEFT));
      case Packets.CLIFF_FRONT_LEFT -> bit(senses.has(Sense.CLIFF_FRONT_LEFT));
      case Packets.CLIFF_FRONT_RIGHT -> bit(senses.has(Sense.CLIFF_FRONT_RIGHT));
      case Packets.CLIFF_RIGHT -> bit(senses.has(Sense.CLIFF_RIGHT));
      case Packets.VIRTUAL_WALL -> bit(senses.has(Sense.VIRTUAL_WALL));
      case Packets.LIGHT_BUMPER -> lightBumper();
      case Packets.INFRARED -> model == CreateModel.CREATE_1 ? 255 : 0;
      case Packets.VOLTAGE -> senses.battery().mv();
      case Packets.CURRENT -> senses.battery().ma();
      case Packets.TEMPERATURE -> senses.battery().celsius();
      case Packets.CHARGE -> senses.battery().chargeMah();
      case Packets.CAPACITY -> senses.battery().capacityMah();
      case Packets.CHARGING_STATE -> senses.has(Sense.CHARGER) && mode == OiMode.PASSIVE ? 2 : 0;
      case Packets.CHARGING_SOURCES -> bit(senses.has(Sense.CHARGER));
      case Packets.MODE -> mode.ordinal();
      case Packets.SONG_NUMBER -> music.number();
      case Packets.SONG_PLAYING -> bit(music.playing(nowNs) >= 0);
      case Packets.STREAM_PACKETS -> streamed == null ? 0 : streamed.length;
      default -> wheels.value(packet);
    };
  }

  private int bumpsAndDrops() {
    return bit(senses.has(Sense.BUMP_RIGHT))
        | bit(senses.has(Sense.BUMP_LEFT)) << 1
        | bit(senses.has(Sense.DROP_RIGHT)) << 2
        | bit(senses.has(Sense.DROP_LEFT)) << 3
        | bit(senses.has(Sense.CASTER_DROP) && model == CreateModel.CREATE_1) << 4;
  }

  private int lightBumper() {
    int bits = 0;
    for (int i = 0; i < CreateBody.LIGHT_BUMPER.size(); i++) {
      bits |= bit(senses.has(CreateBody.LIGHT_BUMPER.get(i))) << i;
    }
    return bits;
  }

  private static int bit(boolean isSet) {
    return isSet ? 1 : 0;
  }

  private static int number(byte[] data, int at) {
    return data[at] << 8 | (data[at + 1] & 0xFF);
  }
}
