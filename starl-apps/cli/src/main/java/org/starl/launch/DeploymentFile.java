package org.starl.launch;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.starl.input.BadInput;
import org.starl.input.TextFile;
import org.starl.robot.file.Deployment;
import org.starl.robot.file.DeploymentReader;
import org.starl.robot.file.RobotEntry;
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
    String secret = deployment.secretOf(robot);
    if (secret == null) {
      return null;
    }
    String where =
        deployment.key() == null
            ? deployment.file() + ":" + robot.line() + ": robots." + robot.id() + ": "
            : deployment.where("key") + "key: ";
    try {
      return deployment.keys(robot, Path.of(deployment.file()).resolveSibling(secret));
    } catch (InvalidPathException e) {
      throw new BadInput(where + BadInput.quote(secret) + ": expected a file's name");
    } catch (IOException e) {
      throw new BadInput(where + e.getMessage());
    }
  }
}
