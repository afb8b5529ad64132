package org.starl.spark;

import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.apache.spark.api.java.JavaRDD;
import org.apache.spark.rdd.PartitionPruningRDD;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.RowFactory;
import org.apache.spark.sql.SparkSession;
import org.apache.spark.sql.types.DataType;
import org.apache.spark.sql.types.DataTypes;
import org.apache.spark.sql.types.StructField;
import org.starl.cli.campaign.CampaignEngine.Rows;
import org.starl.cli.campaign.SeedPart;
import org.starl.cli.report.SeedColumns;
import org.starl.cli.report.SeedRow;
import org.starl.input.BadInput;
import scala.runtime.AbstractFunction1;

/** Writes the rows of a campaign as Parquet; while they pass it collects the names of columns. */
final class ParquetFolder implements Rows {

  private final Rows rows;
  private final SortedMap<String, Class<?>> columns = new TreeMap<>();

  ParquetFolder(Rows rows) {
    this.rows = rows;
  }

  /**
   * @throws BadInput if there is a file or a folder of that name
   */
  static void requireNew(String name) {
    boolean isNew;
    try {
      isNew = name.contains("://") || !Files.exists(Path.of(name)); // a URL is Spark's business
    } catch (InvalidPathException e) {
      isNew = false;
    }
    if (!isNew || name.isEmpty()) {
      throw new BadInput(
          "--parquet: " + BadInput.quote(name) + ": expected the name of a new folder");
    }
  }

  @Override
  public boolean take(SeedPart part, List<String> lines) {
    for (String line : lines) {
      SeedColumns.of(SeedRow.of("", line))
          .forEach((name, value) -> columns.put(name, value.getClass()));
    }
    return rows.take(part, lines);
  }

  @Override
  public long last() {
    return rows.last();
  }

  /** Writes the rows up to the last seed of the result, after all have passed. */
  void write(SparkSession session, JavaRDD<List<String>> lines, List<SeedPart> parts, String folder)
      throws IOException {
    // Names of lemmas and figures may differ in case alone.
    session.conf().set("spark.sql.caseSensitive", "true");
    long last = last();
    int needed = (int) parts.stream().filter(part -> part.first() <= last).count();
    List<String> names = new ArrayList<>(columns.keySet());
    List<StructField> fields = new ArrayList<>();
    names.forEach(name -> fields.add(DataTypes.createStructField(name, type(name), true)));
    JavaRDD<Row> table =
        PartitionPruningRDD.create(lines.rdd(), new First(needed))
            .toJavaRDD()
            .flatMap(List::iterator)
            .map(line -> SeedRow.of("", line))
            .filter(row -> row.seed() <= last)
            .map(row -> row(SeedColumns.of(row), names));
    try {
      session.createDataFrame(table, DataTypes.createStructType(fields)).write().parquet(folder);
    } catch (Exception e) { // methods of Scala do not declare what they throw
      throw SparkEngine.failed(e);
    }
  }

  /** The first partitions: those that were cancelled do not run for the file. */
  private static final class First extends AbstractFunction1<Object, Object>
      implements Serializable {

    private static final long serialVersionUID = 1;
    private final int count;

    First(int count) {
      this.count = count;
    }

    @Override
    public Object apply(Object partition) {
      return (Integer) partition < count;
    }
  }

  private static Row row(Map<String, Object> values, List<String> names) {
    return RowFactory.create(names.stream().map(values::get).toArray());
  }

  private DataType type(String name) {
    Class<?> type = columns.get(name);
    if (type == Long.class) {
      return DataTypes.LongType;
    }
    return type == Double.class ? DataTypes.DoubleType : DataTypes.StringType;
  }
}
