package org.starl.robot.file;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.events.Event;
import org.yaml.snakeyaml.events.MappingStartEvent;
import org.yaml.snakeyaml.events.ScalarEvent;
import org.yaml.snakeyaml.events.SequenceStartEvent;
import org.yaml.snakeyaml.parser.Parser;
import org.yaml.snakeyaml.parser.ParserImpl;
import org.yaml.snakeyaml.reader.StreamReader;

/**
 * Reads the YAML that a person writes for StarL: mappings, lists and single values, one document, no
 * anchors. By the parser's events, for a phone has no reflection on beans.
 */
public final class YamlTree {

  /** Mappings and lists in each other; no file of ours has half as many. */
  private static final int MAX_DEPTH = 16;

  /** What a file has, for messages. */
  public static final String EXPECTED = "expected lines such as 'app: intersection'";

  /** What stands for nothing, unless it is quoted (YAML 1.2, section 10.3.2). */
  private static final Set<String> NULLS =
      new TreeSet<>(Arrays.asList("~", "null", "Null", "NULL"));

  private final String file;
  private final Parser events;

  private YamlTree(String file, Parser events) {
    this.file = file;
    this.events = events;
  }

  /**
   * @param file its name, for messages
   * @throws DeploymentException if it is no YAML, or no mapping; one line for people
   */
  public static Node.Mapping read(String file, String text) {
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
    Node.Mapping mapping = mapping(line(root), 1);
    expect(Event.ID.DocumentEnd);
    if (!events.checkEvent(Event.ID.StreamEnd)) {
      expect(Event.ID.DocumentStart);
      throw wrong(events.getEvent(), "expected one document");
    }
    return mapping;
  }

  private Node.Mapping mapping(int line, int depth) {
    Map<String, Node> parts = new LinkedHashMap<>();
    for (Event name = events.getEvent(); !name.is(Event.ID.MappingEnd); name = events.getEvent()) {
      if (!(name instanceof ScalarEvent scalar)) {
        throw wrong(name, EXPECTED);
      }
      String key = scalar.getValue();
      if (parts.put(key, value(key, line(name), events.getEvent(), depth)) != null) {
        throw wrong(name, key + ": expected once, stands there again");
      }
    }
    return new Node.Mapping(line, parts);
  }

  private Node value(String key, int line, Event value, int depth) {
    if (depth == MAX_DEPTH) {
      throw wrong(value, key + ": expected no more than " + MAX_DEPTH + " levels");
    }
    if (value instanceof MappingStartEvent) {
      return mapping(line, depth + 1);
    }
    if (value instanceof SequenceStartEvent) {
      List<Node> items = new ArrayList<>();
      for (Event item = events.getEvent(); !item.is(Event.ID.SequenceEnd); ) {
        items.add(value(key, line(item), item, depth + 1));
        item = events.getEvent();
      }
      return new Node.Listing(line, items);
    }
    if (value instanceof ScalarEvent scalar) {
      boolean isNull = scalar.isPlain() && NULLS.contains(scalar.getValue());
      return new Node.Text(line, isNull ? "" : scalar.getValue());
    }
    throw wrong(value, key + ": expected one value, or lines beneath");
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
