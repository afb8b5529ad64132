package org.starl.launch;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.Arrays;
import java.util.function.Consumer;
import org.starl.GlobalVarHolder;
import org.starl.RobotRunner;
import org.starl.geometry.Pose;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealStrand;
import org.starl.sim.RobotSpec;

/**
 * A deployed robot's body in a {@link WorldServer}: asks the server, over TCP, to put it on the
 * floor and to take it off. Its pose is the robot's own estimate. Strand only.
 */
final class WorldClient implements OneRobotControl.Body, AutoCloseable {

  /**
   * The protocol: a robot sends its name, then each side sends words, as {@link
   * DataOutputStream#writeUTF} writes strings. So a reader never takes more than 64 KiB at a time
   * from an untrusted connection.
   */
  enum Word {
    /** Robot to world: put me on the floor at my start, once there is room. */
    PLACE,
    /** World to robot: you are on the floor. */
    PLACED,
    /** Robot to world: take me off the floor. */
    LIFT,
    /** World to robot: you are off the floor. */
    LIFTED;

    /**
     * @throws IOException if the next string is not a word; it is not repeated in the message
     */
    static Word read(DataInputStream in) throws IOException {
      String text = in.readUTF();
      return Arrays.stream(values())
          .filter(word -> word.name().equals(text))
          .findFirst()
          .orElseThrow(() -> new IOException("expected one of " + Arrays.toString(values())));
    }
  }

  private static final int CONNECT_MS = 5000;

  private final InetSocketAddress world;
  private final RobotSpec spec;
  private final RealStrand strand;
  private final RobotRunner runner;
  private final Socket socket = new Socket();
  private boolean isAsked;
  private boolean isPlaced;

  private WorldClient(
      InetSocketAddress world, RobotSpec spec, RealStrand strand, RobotRunner runner) {
    this.world = world;
    this.spec = spec;
    this.strand = strand;
    this.runner = runner;
  }

  /**
   * Connects.
   *
   * @param runner runs the robot's program
   * @param onLost takes, from another thread, the loss of the connection; not after {@link #close}
   */
  static WorldClient open(
      InetSocketAddress world,
      RobotSpec spec,
      RealStrand strand,
      RobotRunner runner,
      Consumer<IOException> onLost)
      throws IOException {
    WorldClient client = new WorldClient(world, spec, strand, runner);
    try {
      client.socket.connect(world, CONNECT_MS);
      client.socket.setTcpNoDelay(true);
      client.send(spec.id().name());
    } catch (IOException e) {
      client.close();
      throw client.error(e);
    }
    Daemons.of(spec.id() + " world", () -> client.read(onLost)).start();
    return client;
  }

  private void send(String text) throws IOException {
    new DataOutputStream(socket.getOutputStream()).writeUTF(text);
  }

  private IOException error(IOException cause) {
    String what = cause instanceof EOFException ? "has ended" : cause.getMessage();
    return new IOException("world at " + world + ": " + what, cause);
  }

  private void read(Consumer<IOException> onLost) {
    try (DataInputStream in = new DataInputStream(socket.getInputStream())) {
      while (true) {
        Word word = Word.read(in);
        strand.post(() -> isPlaced = word == Word.PLACED);
      }
    } catch (IOException e) {
      if (!socket.isClosed()) {
        onLost.accept(error(e));
      }
    }
  }

  @Override
  public boolean place() {
    if (!isAsked) {
      isAsked = send(Word.PLACE);
    }
    return isPlaced;
  }

  @Override
  public void lift() {
    if (isAsked) {
      isAsked = false;
      isPlaced = false;
      send(Word.LIFT);
    }
  }

  /** Sends a word; false if the connection is lost, which the reader reports. From any thread. */
  boolean send(Word word) {
    try {
      send(word.name());
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  @Override
  public boolean isOnFloor() {
    return isPlaced;
  }

  /** The world decides. */
  @Override
  public boolean isFree(Pose place) {
    return true;
  }

  /** The robot's own estimate. */
  @Override
  public Pose pose() {
    GlobalVarHolder gvh = runner.gvh();
    return gvh == null || !gvh.gps.hasFix() ? spec.start() : gvh.gps.pose();
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
