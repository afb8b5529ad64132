plugins {
    `java-library`
}

description = "Benchmarks of single parts with JMH: docs/benchmarks.md"

dependencies {
    api(project(":starl-apps"))
    api(libs.jmh.core)
    api(libs.jspecify)
    annotationProcessor(libs.jmh.generator.annprocess)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
