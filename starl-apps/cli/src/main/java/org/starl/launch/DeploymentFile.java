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
import org.starl.robot.udp.KeyFile;

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
   * The key of a deployment, or null if it names none.
   *
   * @throws BadInput if the key's file cannot be read, or others may read it
   */
  public static @Nullable DeploymentKey key(Deployment deployment) {
    if (deployment.key() == null) {
      return null;
    }
    try {
      return KeyFile.read(Path.of(deployment.file()).resolveSibling(deployment.key()));
    } catch (InvalidPathException e) {
      throw new BadInput(
          deployment.where("key")
              + "key: "
              + BadInput.quote(deployment.key())
              + ": expected a file's name");
    } catch (IOException e) {
      throw new BadInput(deployment.where("key") + "key: " + e.getMessage());
    }
  }
}
