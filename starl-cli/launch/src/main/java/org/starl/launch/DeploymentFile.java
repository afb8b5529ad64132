package org.starl.launch;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.TextFile;
import org.starl.platform.DeploymentKey;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.DeploymentReader;
import org.starl.robot.file.Positions;
import org.starl.robot.file.RobotEntry;
import org.starl.robot.udp.KeyFile;
import org.starl.robot.udp.PeerKeys;

/** Reads a deployment file in YAML. All errors are {@link BadInput}. */
public final class DeploymentFile {

  private static final String EXPECTED =
      "expected a deployment file with lines such as 'app: intersection'";

  private DeploymentFile() {}

  /**
   * @throws BadInput if the file is missing, is not text or YAML, or describes no deployment
   */
  public static Deployment read(String file) {
    return parse(file, TextFile.bytes(Path.of(file), EXPECTED));
  }

  /** The same from the bytes of {@code file}. */
  static Deployment parse(String file, byte[] bytes) {
    return DeploymentReader.read(file, TextFile.decode(file, bytes, EXPECTED));
  }

  /**
   * The keys of a robot with the others, from the file of its secret; null if the deployment is not
   * sealed.
   *
   * @throws BadInput if the file cannot be read, others may read it, or it is not this robot's
   */
  public static @Nullable PeerKeys keys(Deployment deployment, RobotEntry robot) {
    String where =
        deployment.key() == null
            ? deployment.file() + ":" + robot.line() + ": robots." + robot.id() + ": "
            : deployment.where("key") + "key: ";
    return read(
        deployment, deployment.secretOf(robot), where, file -> deployment.keys(robot, file));
  }

  /**
   * The key of the lines of the JSON feed, or null if the deployment names none.
   *
   * @throws BadInput if the key's file cannot be read, or others may read it
   */
  public static @Nullable DeploymentKey linesKey(Deployment deployment) {
    String key = deployment.positions() instanceof Positions.JsonFeed json ? json.key() : null;
    return read(deployment, key, deployment.where("positions") + "positions.key: ", KeyFile::read);
  }

  private interface Reader<T> {
    @Nullable T read(Path file) throws IOException;
  }

  private static <T> @Nullable T read(
      Deployment deployment, @Nullable String key, String where, Reader<T> reader) {
    if (key == null) {
      return null;
    }
    try {
      return reader.read(Path.of(deployment.file()).resolveSibling(key));
    } catch (InvalidPathException e) {
      throw new BadInput(where + BadInput.quote(key) + ": expected a file's name");
    } catch (IOException e) {
      throw new BadInput(where + e.getMessage());
    }
  }
}
