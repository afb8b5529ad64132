package org.starl.robot.create;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.sim.check.MalformedBytes;

/**
 * Any bytes to a simulated Create: commands are whole and as long as their opcodes say, wheels turn no
 * faster than they can, nothing turns where nothing may, and it says no more than its line carries.
 */
public class SimulatedCreateFuzzTest {

  private static final long MS = 1_000_000;
  private static final int LONGEST_COMMAND = 2 + 2 * 255;
  private static final int LONGEST_ANSWER = 255 * 80;

  public static void fuzzerTestOneInput(byte[] input) {
    for (CreateModel model : CreateModel.values()) {
      parse(model, input);
      obey(model, input);
    }
  }

  private static void parse(CreateModel model, byte[] input) {
    CommandParser parser = new CommandParser(model);
    int[] bytes = new int[1];
    parser.accept(
        input,
        input.length,
        (opcode, data, length) -> {
          require(opcode >= 0 && opcode <= 255, "opcode " + opcode);
          require(length >= 0 && length <= LONGEST_COMMAND, "a command of " + length);
          bytes[0] += 1 + length;
        });
    long rest = input.length - bytes[0] - parser.unknown();
    require(rest >= 0 && rest <= LONGEST_COMMAND, "bytes that nobody counted: " + rest);
  }

  private static void obey(CreateModel model, byte[] input) {
    Watched body = new Watched();
    SimulatedCreate robot =
        new SimulatedCreate(
            model,
            body,
            said -> require(said.length <= LONGEST_ANSWER, "says " + said.length + " bytes"));
    long nowNs = 0;
    for (int from = 0; from < input.length; from += 7) {
      byte[] piece = Arrays.copyOfRange(input, from, Math.min(from + 7, input.length));
      body.senses =
          switch (from / 7 % 16) {
            case 7 -> CreateBody.Senses.of(CreateBody.Sense.CLIFF_FRONT_LEFT);
            case 11 -> CreateBody.Senses.lifted();
            case 14 -> CreateBody.Senses.of(CreateBody.Sense.CHARGER);
            default -> CreateBody.Senses.NOTHING;
          };
      robot.receive(piece, piece.length, nowNs);
      requireSafe(robot, body);
      nowNs += 10 * MS;
      robot.advance(nowNs);
      requireSafe(robot, body);
    }
  }

  private static void requireSafe(SimulatedCreate robot, Watched body) {
    double left = robot.leftMmPerS();
    double right = robot.rightMmPerS();
    require(Math.abs(left) <= CreateModel.MAX_WHEEL_MM_PER_S, "left at " + left);
    require(Math.abs(right) <= CreateModel.MAX_WHEEL_MM_PER_S, "right at " + right);
    require(left == body.left && right == body.right, "the body does not know");
    boolean mayDrive = robot.mode() == OiMode.SAFE || robot.mode() == OiMode.FULL;
    require(mayDrive || (left == 0 && right == 0), "drives in " + robot.mode());
    require(robot.playing() < 16 && robot.lights().length == 3, "song or lights");
  }

  private static final class Watched implements CreateBody {
    private Senses senses = Senses.NOTHING;
    private double left;
    private double right;

    @Override
    public void drive(double leftMmPerS, double rightMmPerS, long atNs) {
      left = leftMmPerS;
      right = rightMmPerS;
    }

    @Override
    public Senses senses(long atNs) {
      return senses;
    }
  }

  private static void require(boolean holds, String otherwise) {
    if (!holds) {
      throw new AssertionError(otherwise);
    }
  }

  private static byte[] bytes(int... values) {
    byte[] bytes = new byte[values.length];
    for (int i = 0; i < values.length; i++) {
      bytes[i] = (byte) values[i];
    }
    return bytes;
  }

  @Test
  void randomCommandsKeepTheRobotWithinItsLimits() {
    List<byte[]> samples = new ArrayList<>();
    samples.add(
        bytes(128, 132, 145, 0, 200, 0xFF, 156, 137, 0x7F, 0xFF, 0x80, 0, 146, 0, 255, 1, 0));
    samples.add(bytes(128, 131, 140, 0, 2, 60, 8, 62, 8, 141, 0, 139, 10, 128, 255, 142, 6));
    samples.add(bytes(128, 132, 148, 3, 7, 35, 21, 150, 0, 150, 1, 149, 2, 35, 26, 142, 100, 173));
    samples.add(bytes(128, 132, 152, 5, 137, 1, 44, 128, 0, 153, 136, 2, 143, 147, 3, 151, 1));
    samples.add(bytes(128, 132, 137, 0, 100, 1, 244, 145, 0, 50, 0, 50, 7, 128, 133, 129, 11, 131));

    MalformedBytes.feed(samples, SimulatedCreateFuzzTest::fuzzerTestOneInput);
  }
}
