package org.starl.cli;

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
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.sim.input.BadInput;

/**
 * A scenario in YAML: {@code app:} and then any settings and parameters, one a line.
 *
 * <pre>
 * app: intersection
 * robots: 8
 * messageLoss: 0.3
 * messageDelay: uniform(10ms,200ms)
 * debris: 2
 * faults: [crash(bot2,at=12s,restart=5s), loss(0.3,until=60s)]
 * </pre>
 *
 * @param file empty if there is none
 * @param values in the file's order, as text
 * @param lines on which the values stand, and the app
 */
record ScenarioFile(
    String file, String app, Map<String, String> values, Map<String, Integer> lines) {

  static final String APP = "app";
  private static final String FAULTS = "faults";

  private static final String EXPECTED = "expected lines such as 'app: intersection'";

  static boolean isOne(String what) {
    return what.endsWith(".yaml") || what.endsWith(".yml");
  }

  static ScenarioFile ofApp(String app) {
    return new ScenarioFile("", app, Map.of(), Map.of());
  }

  /** What stands before an error in the value of {@code key}: {@code my.yaml:3: }. */
  String where(String key) {
    return file.isEmpty() ? "" : file + ":" + lines.getOrDefault(key, 1) + ": ";
  }

  /** @throws BadInput if it is missing, no text, no YAML, or not as above */
  static ScenarioFile read(String file) {
    Map<String, String> values = new LinkedHashMap<>();
    Map<String, Integer> lines = new LinkedHashMap<>();
    try (JsonParser parser = new YAMLFactory().createParser(text(file))) {
      expect(file, parser, parser.nextToken(), JsonToken.START_OBJECT);
      while (parser.nextToken() != JsonToken.END_OBJECT) {
        String key = parser.currentName();
        JsonToken value = parser.nextToken();
        if (value == JsonToken.START_ARRAY && key.equals(FAULTS)) {
          lines.put(key, parser.currentTokenLocation().getLineNr());
          String faults = faults(file, parser);
          if (values.put(key, faults) != null) {
            throw again(file, parser, key);
          }
          continue;
        }
        if (!value.isScalarValue() || value == JsonToken.VALUE_NULL) {
          throw new BadInput(
              at(file, parser) + key + ": expected one value, such as '" + key + ": 4'");
        }
        lines.put(key, parser.currentTokenLocation().getLineNr());
        if (values.put(key, parser.getText()) != null) {
          throw again(file, parser, key);
        }
      }
      if (parser.nextToken() != null) {
        throw new BadInput(at(file, parser) + "expected one document");
      }
    } catch (JsonProcessingException e) {
      JsonLocation place = e.getLocation();
      String line = place == null ? "" : ":" + place.getLineNr();
      throw new BadInput(file + line + ": is no YAML; " + EXPECTED);
    } catch (IOException e) {
      throw new BadInput(file + ": cannot be read (" + e + ")");
    }
    String app = values.remove(APP);
    if (app == null) {
      throw new BadInput(file + ": has no 'app:'; " + EXPECTED);
    }
    return new ScenarioFile(file, app, values, lines);
  }

  /** What a list says, with commas; those inside a fault may have taken it apart. */
  private static String faults(String file, JsonParser parser) throws IOException {
    List<String> parts = new ArrayList<>();
    while (parser.nextToken() != JsonToken.END_ARRAY) {
      if (!parser.currentToken().isScalarValue()) {
        throw new BadInput(at(file, parser) + FAULTS + ": expected a list of faults");
      }
      parts.add(parser.getText());
    }
    return String.join(",", parts);
  }

  private static BadInput again(String file, JsonParser parser, String key) {
    return new BadInput(at(file, parser) + key + ": expected once, stands there again");
  }

  private static void expect(
      String file, JsonParser parser, @Nullable JsonToken token, JsonToken expected) {
    if (token != expected) {
      throw new BadInput(at(file, parser) + EXPECTED);
    }
  }

  private static String at(String file, JsonParser parser) {
    return file + ":" + Math.max(1, parser.currentTokenLocation().getLineNr()) + ": ";
  }

  private static String text(String file) throws IOException {
    Path path = Path.of(file);
    if (Files.isDirectory(path)) {
      throw new BadInput(file + ": is a folder; expected a scenario file");
    }
    if (!Files.exists(path)) {
      throw new BadInput(file + ": no such file; expected a scenario file");
    }
    try {
      byte[] bytes = Files.readAllBytes(path);
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
