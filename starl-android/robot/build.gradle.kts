plugins {
    `java-library`
    id("maven-publish")
}

description = "The real platform: clock, UDP radio, positioning, iRobot Create; plain JVM"

dependencies {
    api(project(":starl-core"))
    api(project(":starl-core-input"))
    api(libs.jspecify)
    implementation(libs.jserialcomm)
    implementation(libs.jackson.core)
    testImplementation(project(":starl-primitives"))
    testImplementation(project(":starl-sim"))
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testImplementation(libs.lincheck)
    testRuntimeOnly(libs.junit.platform.launcher)
}
