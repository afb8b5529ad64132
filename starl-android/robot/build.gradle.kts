plugins {
    `java-library`
    id("maven-publish")
}

description = "Platform layer, real: clock, UDP, robots; plain JVM"

dependencies {
    api(project(":starl-core"))
    implementation(libs.jserialcomm)
    // Reads deployment files: its parser alone.
    implementation(libs.snakeyaml)
    testImplementation(project(":starl-primitives"))
    testImplementation(project(":starl-sim"))
    api(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
