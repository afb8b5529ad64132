package org.starl.cli.report;

import com.fasterxml.jackson.annotation.JsonAutoDetect.Visibility;
import com.fasterxml.jackson.annotation.PropertyAccessor;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.DeserializationContext;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.deser.std.StdDeserializer;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.module.SimpleModule;
import com.fasterxml.jackson.databind.ser.std.ToStringSerializer;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import org.starl.input.BadInput;
import org.starl.sim.fault.Fault;
import org.starl.sim.fault.FaultGrammar;

/** The rows of shards as JSON, each on one line: records by their components, faults as text. */
public final class RowJson {

  private static final JsonMapper MAPPER =
      JsonMapper.builder()
          .visibility(PropertyAccessor.ALL, Visibility.NONE)
          .visibility(PropertyAccessor.FIELD, Visibility.ANY)
          .visibility(PropertyAccessor.CREATOR, Visibility.ANY)
          .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
          .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .addModule(
              new SimpleModule()
                  .addSerializer(Fault.class, ToStringSerializer.instance)
                  .addDeserializer(Fault.class, new FaultReader()))
          .build();

  private static final class FaultReader extends StdDeserializer<Fault> {
    private static final long serialVersionUID = 1;

    FaultReader() {
      super(Fault.class);
    }

    @Override
    public Fault deserialize(JsonParser parser, DeserializationContext context) throws IOException {
      return FaultGrammar.parse(parser.getText());
    }
  }

  private RowJson() {}

  public static String line(Record row) {
    try {
      return MAPPER.writeValueAsString(row);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("row " + row, e);
    }
  }

  /** A record as an object, for the header of a file. */
  public static Map<String, Object> object(Record values) {
    return MAPPER.convertValue(values, new TypeReference<LinkedHashMap<String, Object>>() {});
  }

  /**
   * The record of an {@link #object}.
   *
   * @throws BadInput if it is none
   */
  public static <R extends Record> R record(Object values, Class<R> type) {
    try {
      return MAPPER.convertValue(values, type);
    } catch (IllegalArgumentException e) {
      throw new BadInput(BadInput.quote(values.toString()) + ": expected values as 'starl' writes");
    }
  }

  /**
   * The row of a line.
   *
   * @param where the place of the line, for errors: {@code part-3:17: }
   * @throws BadInput if it is none
   */
  public static <R extends Record> R read(String where, String line, Class<R> type) {
    try {
      return MAPPER.readValue(line, type);
    } catch (JsonProcessingException | BadInput e) {
      throw new BadInput(where + BadInput.quote(line) + ": expected a row of a shard");
    }
  }
}
