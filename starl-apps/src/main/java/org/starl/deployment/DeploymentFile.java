package org.starl.deployment;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.dataformat.yaml.YAMLFactory;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.deploy.file.Deployment;
import org.starl.deploy.file.DeploymentException;
import org.starl.deploy.file.DeploymentReader;
import org.starl.deploy.file.Node;
import org.starl.deploy.udp.KeyFile;
import org.starl.platform.DeploymentKey;
import org.starl.sim.input.BadInput;

/** A deployment in YAML. All errors are {@link BadInput}. */
public final class DeploymentFile {

  private static final String EXPECTED = "expected lines such as 'app: intersection'";

  private DeploymentFile() {}

  /** @throws BadInput if it is missing, no text, no YAML, or no deployment */
  public static Deployment read(String file) {
    try {
      return parse(file, bytes(file));
    } catch (IOException e) {
      throw new BadInput(file + ": cannot be read (" + e + ")");
    }
  }

  /** The deployment in these bytes of {@code file}. */
  static Deployment parse(String file, byte[] bytes) throws IOException {
    try (JsonParser parser = new YAMLFactory().createParser(text(file, bytes))) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        throw new BadInput(at(file, parser) + EXPECTED);
      }
      Node root = mapping(file, parser);
      if (parser.nextToken() != null) {
        throw new BadInput(at(file, parser) + "expected one document");
      }
      return DeploymentReader.read(file, root);
    } catch (DeploymentException e) {
      throw new BadInput(String.valueOf(e.getMessage()));
    } catch (JsonProcessingException e) {
      JsonLocation place = e.getLocation();
      String line = place == null ? "" : ":" + place.getLineNr();
      throw new BadInput(file + line + ": is no YAML; " + EXPECTED);
    }
  }

  /**
   * The key of a deployment, or null if it names none.
   *
   * @throws BadInput if it cannot be had
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

  private static Node.Mapping mapping(String file, JsonParser parser) throws IOException {
    int line = line(parser);
    Map<String, Node> parts = new LinkedHashMap<>();
    while (parser.nextToken() != JsonToken.END_OBJECT) {
      String name = parser.currentName();
      int nameLine = line(parser);
      JsonToken value = parser.nextToken();
      Node node;
      if (value == JsonToken.START_OBJECT) {
        node = new Node.Mapping(nameLine, mapping(file, parser).parts());
      } else if (value.isScalarValue()) {
        node = new Node.Text(nameLine, value == JsonToken.VALUE_NULL ? "" : parser.getText());
      } else {
        throw new BadInput(
            at(file, parser)
                + BadInput.quote(name)
                + ": a list: expected one value, or lines beneath");
      }
      if (parts.put(name, node) != null) {
        throw new BadInput(
            file
                + ":"
                + nameLine
                + ": "
                + BadInput.quote(name)
                + ": expected once, stands there again");
      }
    }
    return new Node.Mapping(line, parts);
  }

  private static int line(JsonParser parser) {
    return Math.max(1, parser.currentTokenLocation().getLineNr());
  }

  private static String at(String file, JsonParser parser) {
    return file + ":" + line(parser) + ": ";
  }

  private static byte[] bytes(String file) throws IOException {
    Path path = Path.of(file);
    if (Files.isDirectory(path)) {
      throw new BadInput(file + ": is a folder; expected a deployment file");
    }
    if (!Files.exists(path)) {
      throw new BadInput(file + ": no such file; expected a deployment file");
    }
    return Files.readAllBytes(path);
  }

  private static String text(String file, byte[] bytes) {
    try {
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
      if (text.indexOf('\0') < 0) {
        return text;
      }
    } catch (CharacterCodingException e) {
      throw new BadInput(file + ": is no text; " + EXPECTED);
    }
    throw new BadInput(file + ": is no text; " + EXPECTED);
  }
}
