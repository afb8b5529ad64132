package org.starl.android.app;

import java.util.LinkedHashMap;
import java.util.Map;
import org.starl.deploy.file.DeploymentException;
import org.starl.deploy.file.Node;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.events.Event;
import org.yaml.snakeyaml.events.MappingStartEvent;
import org.yaml.snakeyaml.events.ScalarEvent;
import org.yaml.snakeyaml.parser.Parser;
import org.yaml.snakeyaml.parser.ParserImpl;
import org.yaml.snakeyaml.reader.StreamReader;

/**
 * Reads a deployment's YAML on a phone, which has no reflection on beans: by the parser's events, in
 * the same subset as everywhere: mappings and single values.
 */
final class YamlTree {

  private static final String EXPECTED = "expected lines such as 'app: intersection'";

  private final String file;
  private final Parser events;

  private YamlTree(String file, Parser events) {
    this.file = file;
    this.events = events;
  }

  /**
   * @param file its name, for messages
   * @throws DeploymentException if it is no YAML, or no mapping
   */
  static Node.Mapping read(String file, String text) {
    try {
      Parser events = new ParserImpl(new StreamReader(text), new LoaderOptions());
      return new YamlTree(file, events).document();
    } catch (MarkedYAMLException e) {
      String line = e.getProblemMark() == null ? "" : ":" + (e.getProblemMark().getLine() + 1);
      throw new DeploymentException(file + line + ": is no YAML; " + EXPECTED);
    } catch (YAMLException e) {
      throw new DeploymentException(file + ": is no YAML; " + EXPECTED);
    }
  }

  private Node.Mapping document() {
    expect(Event.ID.StreamStart);
    expect(Event.ID.DocumentStart);
    Event root = events.getEvent();
    if (!(root instanceof MappingStartEvent)) {
      throw wrong(root, EXPECTED);
    }
    Node.Mapping mapping = mapping(line(root));
    expect(Event.ID.DocumentEnd);
    if (!events.checkEvent(Event.ID.StreamEnd)) {
      expect(Event.ID.DocumentStart);
      throw wrong(events.getEvent(), "expected one document");
    }
    return mapping;
  }

  private Node.Mapping mapping(int line) {
    Map<String, Node> parts = new LinkedHashMap<>();
    for (Event name = events.getEvent(); !name.is(Event.ID.MappingEnd); name = events.getEvent()) {
      if (!(name instanceof ScalarEvent scalar)) {
        throw wrong(name, EXPECTED);
      }
      String key = scalar.getValue();
      if (parts.put(key, value(key, line(name))) != null) {
        throw wrong(name, key + ": expected once, stands there again");
      }
    }
    return new Node.Mapping(line, parts);
  }

  private Node value(String key, int line) {
    Event value = events.getEvent();
    if (value instanceof MappingStartEvent) {
      return mapping(line);
    }
    if (value instanceof ScalarEvent scalar) {
      boolean isNull = scalar.isPlain() && scalar.getValue().equals("~");
      return new Node.Text(line, isNull ? "" : scalar.getValue());
    }
    throw wrong(value, key + ": a list: expected one value, or lines beneath");
  }

  private void expect(Event.ID kind) {
    Event event = events.getEvent();
    if (!event.is(kind)) {
      throw wrong(event, EXPECTED);
    }
  }

  private static int line(Event event) {
    return event.getStartMark().getLine() + 1;
  }

  private DeploymentException wrong(Event event, String what) {
    return new DeploymentException(file + ":" + line(event) + ": " + what);
  }
}
