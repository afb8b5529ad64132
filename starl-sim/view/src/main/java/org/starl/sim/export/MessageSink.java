package org.starl.sim.export;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;

/** Takes messages on topics, each topic with a JSON schema: a file, or a connection. */
public interface MessageSink {

  /**
   * A type of messages.
   *
   * @param json its JSON schema
   * @param isNumber whether it is of variables that are numbers
   */
  record Schema(String name, String json, boolean isNumber) {}

  /** Opens a channel; returns its number, for {@link #message}. */
  int channel(String topic, Schema schema);

  /**
   * Takes a message.
   *
   * @param timeNs from the start of the run; does not decrease
   */
  void message(int channel, long timeNs, ObjectNode message);

  /** A message as JSON in UTF-8. */
  static byte[] bytes(ObjectMapper json, ObjectNode message) {
    try {
      return json.writeValueAsBytes(message);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a message that is not JSON", e);
    }
  }
}
